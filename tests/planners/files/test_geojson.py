from __future__ import annotations

import json

import pytest

from planners import files
from planners.errors import InputError
from planners.frame import Frame
from planners.path import Path

LINE = {"type": "LineString", "coordinates": [[8.0, 47.0, 500], [8.01, 47.0, 510]]}
POLYGON = {"type": "Polygon", "coordinates": [[[8, 47], [8, 48], [9, 48], [8, 47]]]}
POINT = {"type": "Point", "coordinates": [8.0, 47.0]}


def feature(geometry: object) -> dict[str, object]:
    return {"type": "Feature", "properties": {"name": "a"}, "geometry": geometry}


def line(coordinates: object) -> dict[str, object]:
    return {"type": "LineString", "coordinates": coordinates}


def collection(*geometries: object) -> dict[str, object]:
    return {"type": "FeatureCollection", "features": [feature(geometry) for geometry in geometries]}


@pytest.mark.parametrize(
    "data",
    [
        LINE,
        feature(LINE),
        collection(LINE),
        {"type": "GeometryCollection", "geometries": [LINE]},
    ],
)
def test_one_line(read, data):
    file = read("a.geojson", json.dumps(data))
    assert file.path.frame == Frame(47.0, 8.0)
    assert file.path.points[1] == pytest.approx([760.6, 0.05, 510.0], abs=0.1)  # east, and up
    assert file.notes == ()


def test_other_features_are_skipped_with_a_note(read):
    file = read("a.json", json.dumps(collection(POINT, LINE, None)))
    assert file.notes == ("feature 1: a Point is not a path",)


def test_no_altitude_and_more_than_one(read):
    assert read("a.geojson", '{"type":"LineString","coordinates":[[8,47],[8,48]]}').path.z is None
    assert read("b.geojson", '{"type":"LineString","coordinates":[[8,47,1,9],[8,48,2]]}').path.z.tolist() == [
        1,
        2,
    ]


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (collection(LINE, POINT, LINE), "2 LineStrings (feature 1, feature 3), and a path file holds one"),
        (POINT, "no LineString, only Point; export the path as one LineString"),
        (feature(POLYGON), "no LineString, only Polygon; export the path as one LineString"),
        ({"type": "MultiLineString", "coordinates": []}, "no LineString, only MultiLineString; export"),
        (collection(), "no LineString, only nothing"),
        ({"fileType": "Plan"}, "Object missing required field type"),
        ({"type": "LineString"}, "the geometry: coordinates: "),
        (line([]), "a path needs at least two points, this has 0"),
        (line([[8, 47], [8]]), "position 2: 1 numbers; give longitude, latitude"),
        (line([[8, 47, 1], [8, 48]]), "position 2: no altitude, but others have"),
        (line([[8, 47], [8, "48"]]), "the geometry: coordinates: $[1][1]: expected f"),
        (line([[47, 8], [122, 8], [8, 122]]), "position 3: latitude 122.0 is not within"),
        (line([[8, 47], [8, 47]]), "position 2: the point is in the same place as posi"),
    ],
)  # fmt: skip
def test_refused(refusal, data, said):
    assert refusal("a.geojson", json.dumps(data)).startswith(said)


def test_written_in_the_order_of_rfc_7946(tmp_path):
    files.write(Path([[0.0, 0.0, 5.0], [0.0, 100.0, 6.0]], Frame(47.0, 8.0), "north"), tmp_path / "a.geojson")
    data = json.loads((tmp_path / "a.geojson").read_text())
    assert data["type"] == "Feature"
    assert data["properties"] == {"name": "north"}
    assert data["geometry"]["coordinates"][0] == [8.0, 47.0, 5.0]


@pytest.mark.parametrize("name", ["a.geojson", "a.plan", "a.waypoints"])
@pytest.mark.parametrize("frame", [None, Frame(4.5, 137.4, 3396190.0, 3376200.0)])
def test_paths_off_earth_are_not_written(tmp_path, name, frame):
    with pytest.raises(InputError, match=rf"{name}: the path (has no place|is not) on Earth.*; write it as \.csv"):
        files.write(Path([[0.0, 0.0], [1.0, 0.0]], frame), tmp_path / name)
    files.write(Path([[0.0, 0.0], [1.0, 0.0]], frame), tmp_path / "a.csv")
    assert (tmp_path / "a.csv").read_text() == "x,y\n0.0,0.0\n1.0,0.0\n"
