from __future__ import annotations

import numpy as np
import pytest

from planners import files
from planners.path import Path


def test_metres(read):
    path = read("loop.csv", "x,y,z\n0,0,10\n3,4,12\n").path
    assert path.points.tolist() == [[0.0, 0.0, 10.0], [3.0, 4.0, 12.0]]
    assert (path.frame, path.name) == (None, "loop")


def test_columns_in_any_order_with_units_and_others_beside_them(read):
    file = read("a.csv", '"Time (s)", ALT [m] ,Longitude_deg,"latitude (deg)"\n0, 5, 8, 47\n1, 6, 8, 47.01\n')
    assert (file.path.frame.lat, file.path.frame.lon) == (47.0, 8.0)
    assert file.path.z.tolist() == [5.0, 6.0]
    assert file.path.length == pytest.approx(1111.8, abs=0.1)  # 0.01 deg of meridian at 47 deg
    assert file.notes == ("column 'Time (s)' is ignored",)


@pytest.mark.parametrize("title", ["lat,lng,altitude", "Latitude,Long,height", "lat,lon,z", "LAT,LON,ele"])
def test_aliases(read, title):
    assert read("a.csv", f"{title}\n1,2,3\n1.1,2,3\n").path.frame is not None


def test_headless_is_metres_and_says_so(read):
    file = read("a.csv", "# a planner's output\n\n0, 0 # the start\n1e1, 0\n")
    assert file.path.points.tolist() == [[0.0, 0.0], [10.0, 0.0]]
    assert file.notes == ("no header: the columns are taken as x, y[, z] in metres",)


def test_header_in_a_comment(read):
    assert read("a.csv", "# saved by numpy\n# lat,lon\n47,8\n47.1,8\n").path.frame is not None


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is empty; give one point a line"),
        ("# nothing\n\n", "is empty; give one point a line"),
        ("x,y\n", "a path needs at least two points, this has 0; add points"),
        ("lat,lon\n", "a path needs at least two points, this has 0; add points"),
        ("lat,lon\n1,2\n", "a path needs at least two points, this has 1; add points"),
        ("x,y\n0,0\n1,nan\n", "line 3: 'nan' is not a finite number"),
        ("x,y\n0,0\n-inf,0\n", "line 3: '-inf' is not a finite number"),
        ("x,y\n0,0\n1,\n", "line 3: '' is not a number"),
        ("x,y\n0,0\n1,1_0\n", "line 3: '1_0' is not a number"),
        ("x,y\n0,0\n\n# note\n1,here\n", "line 5: 'here' is not a number"),
        ("x,y\n0,0\n1,0,0\n", "line 3: 3 columns where line 1 has 2"),
        ("0,0\n1\n", "line 2: 1 columns where line 1 has 2"),
        ("1,2,3,4\n", "line 1: 4 columns and no header; name the columns x, y[, z]"),
        ("1;2\n3;4\n", "line 1: there is only one column; separate columns by commas"),
        ("x,y,lat,lon\n", "line 1: metres (x, y) and degrees (lat, lon) are mixed"),
        ("x,lon\n", "line 1: metres (x, y) and degrees (lat, lon) are mixed"),
        ("x,z\n", "line 1: no x and y, no lat and lon among 'x', 'z'; name the columns"),
        ("easting,northing\n", "line 1: no x and y, no lat and lon among 'easting', 'northing'"),
        ("lat,latitude,lon\n", "line 1: columns 'lat' and 'latitude' mean the same; leave one out"),
        ("lat,lon,alt_ft\n", "line 1: column 'alt_ft' has another unit; convert it to metres"),
        ("x [km],y [km]\n", "line 1: column 'x [km]' has another unit; convert it to metres"),
        ("lat_rad,lon_rad\n", "line 1: column 'lat_rad' has another unit; convert it to degrees"),
        ("lat,lon\n47,8\n123,8\n", "line 3: latitude 123.0 is not within +-90 degrees; give degrees"),
        ("lat,lon\n47,8\n47,-181\n", "line 3: longitude -181.0 is not within +-180 degrees"),
        (
            "x,y\n0,0\n# here\n1,0\n1,0\n",
            "line 5: the point is in the same place as line 4, or straight above it; leave one",
        ),
        ("x,y,z\n0,0,0\n0,0,9\n", "line 3: the point is in the same place as line 2"),
        ("lat,lon\n47,180\n47,-180\n", "line 3: the point is in the same place as line 2"),
        ("x,y\n0,0\n" + "9" * 200_000 + ",0\n", "line 3: broken CSV: field larger than field limit"),
        ("x,y\n0,0\n1e308,0\n", "line 3: [1e+308, 0.0] is beyond 1e+09 m; give coordinates in a local"),
        ("lat,lon,alt\n0,0,0\n0,0.1,1e300\n", "line 3: [11131.9"),
        ("x,y\n0,0\n1e999,0\n", "line 3: '1e999' is not a finite number"),
    ],
)
def test_refused(refusal, text, said):
    assert refusal("a.csv", text).startswith(said)


def test_metres_are_written_without_loss(tmp_path):
    points = np.random.default_rng(1).normal(scale=1e5, size=(100, 3))
    files.write(Path(points), tmp_path / "a.csv")
    assert (files.read(tmp_path / "a.csv").path.points == points).all()


def test_far_points_are_noted(read):
    assert read("a.csv", "lat,lon\n47,8\n49,8\n").notes == (
        "the path goes 222 km from its first point; distances across it are stretched there",
    )


def test_across_the_antimeridian(read):
    assert read("a.csv", "lat,lon\n0,179.99\n0,-179.99\n").path.length == pytest.approx(2226.4, abs=0.1)
