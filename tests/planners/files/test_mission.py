from __future__ import annotations

import math
from typing import Any

import pytest

from planners.errors import InputError
from planners.files import commands
from planners.files.mission import MissionItem, take_path
from planners.files.source import PathFile, Source
from planners.frame import Frame

ABSOLUTE, MISSION, RELATIVE, TERRAIN = 0, 2, 3, 10


def item(command: int = commands.NAV_WAYPOINT, **values: Any) -> dict[str, Any]:
    return {
        "command": command,
        "frame": ABSOLUTE,
        "speed": None,
        "lat": None,
        "lon": None,
        "alt": 100.0,
    } | values


def at(lat: float, **values: Any) -> dict[str, Any]:
    return item(**{"lat": lat, "lon": 8.0} | values)


def take(*items: dict[str, Any], home_alt: float | None = 400.0) -> PathFile:
    numbered = [MissionItem(label=f"item {i}", **values) for i, values in enumerate(items, 1)]
    return take_path(Source("", "a.plan", "a"), numbered, home_alt)


def note(command: dict[str, Any]) -> str:
    """The one note on `command` between two waypoints, of which it leaves nothing but the straight line."""
    file = take(at(47.0), command, at(47.01))
    assert len(file.path.points) == 2
    (said,) = file.notes
    return said


def refusal(*items: dict[str, Any]) -> str:
    with pytest.raises(InputError) as caught:
        take(*items)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_waypoints_are_a_path_about_the_first_one():
    file = take(at(47.0), at(47.01, alt=120.0))
    assert (file.path.frame, file.path.name, file.notes) == (Frame(47.0, 8.0), "a", ())
    assert file.path.xy[0].tolist() == [0.0, 0.0]
    assert file.path.z.tolist() == [100.0, 120.0]
    assert file.path.length == pytest.approx(1111.8, abs=0.1)


@pytest.mark.parametrize(
    ("command", "name", "why"),
    [
        (22, "NAV_TAKEOFF", "the take-off is not flown, the path starts at the first waypoint"),
        (84, "NAV_VTOL_TAKEOFF", "the take-off is not flown, the path starts at the first waypoint"),
        (21, "NAV_LAND", "the landing is not flown, the path ends at the last waypoint"),
        (20, "NAV_RETURN_TO_LAUNCH", "the way home is not flown"),
        (177, "DO_JUMP", "loops are flown once"),
        (201, "DO_SET_ROI", "it is no waypoint"),
        (5001, "command", "fence and rally points are not part of a path"),
        (31415, "command", "unknown command"),
    ],
)
def test_commands_that_are_skipped_even_with_a_position(command, name, why):
    assert note(at(47.005, command=command)) == f"item 2: {name} ({command}): {why}"


@pytest.mark.parametrize("command", [17, 18, 19, 31])
def test_of_a_loiter_the_point_is_taken(command):
    file = take(at(47.0), at(47.005, command=command), at(47.01))
    assert len(file.path.points) == 3
    assert file.notes == (
        f"item 2: {commands.NAMES[command]} ({command}): its point is taken, the circles are not flown",
    )


def test_splines_are_corners():
    file = take(at(47.0), at(47.005, command=82), at(47.01, command=82))
    assert len(file.path.points) == 3
    assert file.notes == ("item 2 and 1 more: a spline is taken as a corner, its curve is not modelled",)


@pytest.mark.parametrize(
    ("values", "why"),
    [
        ({"lat": 0.0, "lon": 0.0}, "no position"),
        ({"lat": None, "lon": 8.0}, "no position"),
        ({"lat": 47.0, "lon": None}, "no position"),
        ({"lat": 47.005, "lon": 8.0, "frame": MISSION}, "frame 2 gives no latitude and longitude"),
        ({"lat": 10.0, "lon": 20.0, "frame": 1}, "frame 1 gives no latitude and longitude"),
        ({"lat": 47.0, "lon": 8.0}, "the same place as item 1"),
        ({"lat": 47.0 + 1e-12, "lon": 8.0 - 4e-8}, "the same place as item 1"),
        ({"lat": 47.0, "lon": 8.0, "alt": 150.0}, "the same place as item 1, only the height differs"),
    ],
)
def test_waypoints_that_are_skipped(values, why):
    assert note(item(**values)) == f"item 2: NAV_WAYPOINT (16): {why}"


def test_same_place_across_the_antimeridian():
    file = take(at(47.0, lon=180.0), at(47.0, lon=-180.0), at(47.1, lon=180.0))
    assert file.notes == ("item 2: NAV_WAYPOINT (16): the same place as item 1",)


def test_a_closed_circuit_is_no_repetition():
    assert take(at(47.0), at(47.01), at(47.0)).notes == ()


@pytest.mark.parametrize("frame", [RELATIVE, 6])
def test_relative_heights_are_lifted_by_home(frame):
    file = take(at(47.0, frame=frame, alt=50.0), at(47.01, frame=5, alt=470.0))
    assert file.path.z.tolist() == [450.0, 470.0]
    assert file.notes == ()


@pytest.mark.parametrize("home_alt", [None, 0.0])
def test_unknown_home(home_alt):
    file = take(at(47.0, frame=RELATIVE), at(47.01, frame=RELATIVE), home_alt=home_alt)
    assert file.path.z.tolist() == [100.0, 100.0]
    assert file.notes == (
        "item 1 and 1 more: the altitude of home is not known, heights relative to it are taken as above 0 m",
    )


@pytest.mark.parametrize("frame", [TERRAIN, 11])
def test_terrain(frame):
    file = take(at(47.0, frame=frame, alt=30.0), at(47.01))
    assert file.path.z.tolist() == [430.0, 100.0]
    assert file.notes == ("item 1: heights above the terrain are taken as above home, there is no terrain model",)


def test_null_altitude_is_that_of_the_item_before():
    file = take(at(47.0, alt=90.0), at(47.01, alt=None), at(47.02, frame=RELATIVE, alt=None))
    assert file.path.z.tolist() == [90.0, 90.0, 90.0]
    assert file.notes == ("item 2 and 1 more: no altitude, taken as that of the item before",)


def test_null_altitude_after_a_take_off_is_the_height_taken_off_to():
    file = take(item(22, frame=RELATIVE, alt=50.0), at(47.0, alt=None), at(47.01, alt=None))
    assert file.path.z.tolist() == [450.0, 450.0]


def test_null_altitude_first_is_that_of_home():
    file = take(at(47.0, alt=None), at(47.01))
    assert file.path.z.tolist() == [400.0, 100.0]
    assert file.notes == ("item 1: no altitude, taken as that of home",)


def test_speed_before_the_first_leg():
    file = take(item(178, speed=12.0), at(47.0), item(178, speed=17.0), at(47.01))
    assert (file.speed, file.notes) == (17.0, ())


def test_speed_along_the_path():
    file = take(at(47.0), at(47.01), item(178, speed=20.0), at(47.02))
    assert file.speed is None
    assert file.notes == ("item 3: DO_CHANGE_SPEED (178): a change to 20 m/s along the path is not flown",)


@pytest.mark.parametrize("speed", [None, -1.0, 0.0, math.nan, math.inf])
def test_no_speed(speed):
    assert note(item(178, speed=speed)) == "item 2: DO_CHANGE_SPEED (178): it sets no speed"


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"lat": 91.0}, "latitude 91.0 is not within +-90 degrees; give degrees"),
        ({"lon": 180.1}, "longitude 180.1 is not within +-180 degrees; give degrees"),
        ({"lat": 473977420.0}, "latitude 473977420.0 is not within +-90 degrees"),
        ({"lat": math.nan}, "latitude nan is not within"),
        ({"lon": -math.inf}, "longitude -inf is not within"),
        ({"alt": math.nan}, "altitude nan is not a finite number; give metres"),
        ({"alt": math.inf}, "altitude inf is not a finite number"),
    ],
)
def test_impossible_positions(values, said):
    assert refusal(at(47.0), item(**{"lat": 47.01, "lon": 8.0} | values)).startswith(f"a.plan: item 2: {said}")


def test_fewer_than_two_waypoints():
    assert refusal() == (
        "a.plan: a path needs at least two waypoints, this mission has none; "
        "add waypoints (NAV_WAYPOINT, 16) with a position"
    )
    assert refusal(at(47.0), item(20)) == (
        "a.plan: a path needs at least two waypoints, this mission has 1 (skipped: 1, first item 2: "
        "NAV_RETURN_TO_LAUNCH (20): the way home is not flown); "
        "add waypoints (NAV_WAYPOINT, 16) with a position"
    )


def test_notes_are_single_lines_and_each_skipped_item_has_one():
    file = take(item(22), at(47.0), item(206), at(47.0), at(47.01, command=18), item(177), at(47.02), item(20))
    assert [line.split(":")[0] for line in file.notes] == [f"item {i}" for i in (1, 3, 4, 5, 6, 8)]
