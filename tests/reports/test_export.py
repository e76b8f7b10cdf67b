import csv
import dataclasses
import json
import math
from xml.etree import ElementTree

import numpy as np
import pytest

from planners.errors import InputError
from reports.files.export import SUFFIXES, export

KML = "{http://www.opengis.net/kml/2.2}"


def read_csv(file):
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def shortened(outcome, rows, **columns):
    data = np.array(outcome.track.data[rows])
    for name, value in columns.items():
        data[:, outcome.track.columns.index(name)] = value
    return dataclasses.replace(outcome, track=dataclasses.replace(outcome.track, data=data))


def test_unknown_suffix_names_the_known_ones(route, tmp_path):
    with pytest.raises(InputError, match=r"cannot export \.xlsx; use \.csv, \.kml, \.geojson, \.tlog"):
        export(route, tmp_path / "a.xlsx")
    with pytest.raises(InputError, match="without a suffix"):
        export(route, tmp_path / "a")


@pytest.mark.parametrize("suffix", [suffix for suffix in SUFFIXES if suffix != ".csv"])
def test_a_local_path_has_no_coordinates(yard, suffix, tmp_path):
    with pytest.raises(InputError, match=r"no geographic origin.*export CSV"):
        export(yard, tmp_path / f"a{suffix}")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_same_bytes_twice_and_nothing_else(route, suffix, tmp_path):
    for name in ("a", "b"):
        export(route, tmp_path / f"{name}{suffix}")
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("rows", [slice(0, 0), slice(0, 1), slice(0, 2)])
def test_short_tracks(route, suffix, rows, tmp_path):
    export(shortened(route, rows), tmp_path / f"a{suffix}")


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_upper_case_suffix(route, suffix, tmp_path):
    export(route, tmp_path / f"a{suffix.upper()}")


def test_csv_has_units_and_degrees(route, tmp_path):
    export(route, tmp_path / "a.csv")
    rows = read_csv(tmp_path / "a.csv")
    track = route.track
    assert len(rows) == len(track)
    assert float(rows[50]["bank [deg]"]) == pytest.approx(math.degrees(track["bank"][50]), rel=1e-8)
    assert float(rows[50]["heading [deg from east]"]) == pytest.approx(math.degrees(track["heading"][50]), rel=1e-8)
    assert float(rows[50]["curvature [1/m]"]) == pytest.approx(track["curvature"][50], rel=1e-8)
    xy = np.array([[float(row["latitude [deg]"]), float(row["longitude [deg]"])] for row in rows])
    local = track.frame.to_local(xy[:, 0], xy[:, 1])
    assert np.abs(local - np.column_stack([track["x"], track["y"]])).max() < 1e-3


def test_csv_of_a_local_path(yard, tmp_path):
    export(yard, tmp_path / "a.csv")
    [row, *_] = read_csv(tmp_path / "a.csv")
    assert "latitude [deg]" not in row
    assert len(row) == len(yard.track.columns)


def test_csv_leaves_no_number_empty(route, tmp_path):
    export(shortened(route, slice(0, 3), x=math.nan), tmp_path / "a.csv")
    [row, *_] = read_csv(tmp_path / "a.csv")
    assert row["x [m]"] == ""
    assert row["latitude [deg]"] == ""


def test_kml_is_well_formed_and_escaped(route, tmp_path):
    named = dataclasses.replace(route, name='<a> & "b" \x00 名字')
    export(named, tmp_path / "a.kml")
    root = ElementTree.parse(tmp_path / "a.kml").getroot()
    assert root.tag == f"{KML}kml"
    document = root.find(f"{KML}Document")
    assert document.find(f"{KML}name").text == '<a> & "b"  名字'
    marks = {mark.find(f"{KML}name").text: mark for mark in document.iter(f"{KML}Placemark")}
    assert {"planned", "flown"} <= set(marks)
    first = marks["planned"].find(f".//{KML}coordinates").text.split()[0]
    lon, lat, height = map(float, first.split(","))
    assert (lat, lon, height) == pytest.approx((48.1, 11.6, 300.0), abs=1e-8)
    assert marks["flown"].find(f".//{KML}altitudeMode").text == "absolute"
    [worst] = (mark for name, mark in marks.items() if name.startswith("Worst point: cross-track error"))
    assert worst.find(f".//{KML}altitudeMode").text == "absolute"
    index = int(np.argmax(np.abs(route.track["cross_track"])))
    height = float(worst.find(f".//{KML}coordinates").text.split(",")[2])
    assert height == pytest.approx(route.track["z"][index], abs=1e-3)


def test_geojson(route, tmp_path):
    export(route, tmp_path / "a.geojson")
    told = json.loads((tmp_path / "a.geojson").read_text(encoding="utf-8"))
    assert told["type"] == "FeatureCollection"
    planned, flown = told["features"]
    assert planned["properties"]["line"] == "planned"
    assert planned["geometry"]["coordinates"][0] == pytest.approx([11.6, 48.1, 300.0])
    assert len(flown["geometry"]["coordinates"]) == len(route.track)
    assert flown["properties"]["verdict"] == "not-trackworthy"


def test_geojson_of_one_and_of_no_sample(route, tmp_path):
    for count, kind in ((1, "Point"), (0, None)):
        export(shortened(route, slice(0, count)), tmp_path / "a.geojson")
        geometry = json.loads((tmp_path / "a.geojson").read_text())["features"][1]["geometry"]
        assert (geometry and geometry["type"]) == kind
