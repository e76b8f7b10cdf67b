from __future__ import annotations

import pytest

from planners import files
from planners.errors import InputError
from planners.frame import Frame
from planners.path import Path

# as a ground station leaves it: home, take-off, camera, a jump, a repeated waypoint, loiter, landing
MISSION = """QGC WPL 110
0\t1\t0\t16\t0\t0\t0\t0\t-35.363262\t149.165237\t584.000000\t1
1\t0\t3\t22\t15.00000000\t0\t0\t0\t0.00000000\t0.00000000\t50.000000\t1
2\t0\t3\t178\t1.0\t18.0\t0\t0\t0.0\t0.0\t0.0\t1
3\t0\t3\t16\t0\t0\t0\tnan\t-35.36000000\t149.16500000\t100.000000\t1
# a comment, as MAVProxy writes it

4 0 3 206 25.0 0 0 0 0 0 0 1
5\t0\t3\t82\t0\t0\t0\t0\t-35.35500000\t149.16000000\t100.000000\t1
6\t0\t3\t16\t0\t0\t0\t0\t-35.35500000\t149.16000000\t120.000000\t1
7\t0\t0\t18\t3\t0\t50\t0\t-35.35500000\t149.17000000\t700.000000\t1
8\t0\t3\t177\t3\t2\t0\t0\t0\t0\t0\t1
9\t0\t3\t21\t0\t0\t0\t0\t-35.36300000\t149.16500000\t0.000000\t1
"""


HEADER = "QGC WPL 110\n"


def item(index: int, lat: float, lon: float, command: int = 16) -> str:
    return f"{index}\t0\t0\t{command}\t0\t0\t0\t0\t{lat}\t{lon}\t100\t1\n"


@pytest.mark.parametrize("name", ["a.waypoints", "a.txt"])
def test_a_real_mission(read, name):
    file = read(name, MISSION)
    assert file.path.frame == Frame(-35.36, 149.165)
    assert file.path.z.tolist() == [684.0, 684.0, 700.0]
    assert (file.speed, file.fence) == (18.0, None)
    assert file.notes == (
        "item 0: home, not a part of the path",
        "item 1: NAV_TAKEOFF (22): the take-off is not flown, the path starts at the first waypoint",
        "item 4: DO_SET_CAM_TRIGG_DIST (206): it is no waypoint",
        "item 6: NAV_WAYPOINT (16): the same place as item 5, only the height differs",
        "item 7: NAV_LOITER_TURNS (18): its point is taken, the circles are not flown",
        "item 8: DO_JUMP (177): loops are flown once",
        "item 9: NAV_LAND (21): the landing is not flown, the path ends at the last waypoint",
        "item 5: a spline is taken as a corner, its curve is not modelled",
    )


def test_item_0_is_home_even_with_a_relative_altitude(read):
    file = read("a.waypoints", MISSION.replace("0\t1\t0\t16", "0\t1\t3\t16"))
    assert file.path.z.tolist() == [100.0, 100.0, 700.0]
    assert "the altitude of home is not known" in file.notes[-2]


def test_item_0_that_is_no_home_is_said_to_be_none(read):
    file = read("a.waypoints", HEADER + item(0, 47, 8, 22) + item(1, 47, 8) + item(2, 48, 8))
    assert file.notes[0] == "item 0: not home, as it should be, but a command of the mission"
    assert len(file.path.points) == 2


def test_version_120_has_no_home(read):
    file = read("a.txt", "QGC WPL 120\r\n" + item(0, 47, 8) + item(1, 47.1, 8))
    assert len(file.path.points) == 2
    assert file.notes == ()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "line 1: the file is empty; give a mission saved as QGC WPL 110"),
        ("lat,lon\n", "line 1: the first line is 'lat,lon', not 'QGC WPL 110'; give a mission"),
        ("-35.1\t149.2\n-35.2\t149.3\n", "line 1: is a list of positions (an ArduPilot fence?)"),
        ("#saved by APM\n-35.1 149.2\n", "line 2: is a list of positions (an ArduPilot fence?)"),
        ("RALLY -35.1 149.2 100 40 0 0\n", "line 1: is an ArduPilot list of rally points, not a mission"),
        ("QGC WPL 100\n", "line 1: QGC WPL version '100' is not known; export it as QGC WPL 110"),
        ("QGC WPL 110\n", "a path needs at least two waypoints, this mission has none; add"),
        (HEADER + item(0, 47, 8) + item(1, 47, 8), "a path needs at least two waypoints, this mi"),
        (HEADER + item(0, 47, 8) + item(1, 47, 8, 5001) * 3, "is a geofence, not a mission; give"),
        (HEADER + item(0, 47, 8) + item(1, 47, 8, 5100), "is a list of rally points, not a mission"),
        (HEADER + item(0, 47, 8) + "1\t0\t0\n", "line 3: 3 fields, an item has 12; correct it"),
        (HEADER + item(0, 47, 8).replace("47", "47,0"), "line 2: '47,0' is not a number"),
        (HEADER + item(0, 47, 8).replace("16", "1.5"), "line 2: command 1.5 is not a whole number"),
        (HEADER + item(0, 47, 8).replace("16", "nan"), "line 2: command nan is not a whole number"),
        (HEADER + item(0, 47, 8) + item(1, 47, 181), "item 1: longitude 181.0 is not within"),
    ],
)  # fmt: skip
def test_refused(refusal, text, said):
    assert refusal("a.waypoints", text).startswith(said)


def test_written_with_home_first(tmp_path):
    files.write(Path([[0.0, 0.0], [1000.0, 0.0]], Frame(47.0, 8.0)), tmp_path / "a.waypoints")
    lines = (tmp_path / "a.waypoints").read_text().splitlines()
    assert lines[0] == "QGC WPL 110"
    assert lines[1] == "0\t1\t0\t16\t0\t0\t0\t0\t47.0000000000\t8.0000000000\t0.000000\t1"
    assert lines[2] == "1\t0\t0\t16\t0\t0\t0\t0\t47.0000000000\t8.0000000000\t0.000000\t1"
    assert len(lines) == 4


@pytest.mark.parametrize("name", ["a.waypoints", "a.plan"])
def test_a_point_at_0_0_is_not_written(tmp_path, name):
    with pytest.raises(InputError, match=r"point 1 is at latitude 0, longitude 0: no position in a mission; write"):
        files.write(Path([[0.0, 0.0], [1.0, 0.0]], Frame(0.0, 0.0)), tmp_path / name)
