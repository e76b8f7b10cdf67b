"""What holds for every planner of fleets."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.all_planners import make_planner, plan_with
from planners.errors import InputError
from planners.map import Circle
from planners.planner import NO_PATH, NOT_FOUND
from planners.scenario import load_scenario, scaled
from planners.units import wrap_all
from sample_maps import HEIGHT, UNIT, WIDTH, room, scenario, within

SMALL = {"pigeons": 40, "compass_iterations": 20, "landmark_iterations": 5}
FLEETS = {"exact": {}, "vd": {}, "vdp-pio": SMALL, "vdp": SMALL}
MARS = load_scenario("mars-hazards-25")


def planner(name):
    return make_planner(name, {"clearance": UNIT, **FLEETS[name]})


def fleet(circles, starts, goals, max_range=None, max_turn_angle=None):
    """Starts and goals in map units."""
    one = scenario(circles=circles)
    places = [np.array(places, dtype=float) * UNIT for places in (starts, goals)]
    longest = None if max_range is None else max_range * UNIT
    return replace(one, starts=places[0], goals=places[1], max_range=longest, max_turn_angle=max_turn_angle)


def sharpest(path):
    return np.abs(wrap_all(np.diff(path.headings))).max(initial=0.0)


places = st.tuples(within(2.0, HEIGHT - 2.0), st.integers(0, 30))
fleets = st.builds(
    lambda circles, starts, goals, longest, sharp: fleet(
        circles,
        [(3.0 + x / 10.0, y) for y, x in starts],
        [(WIDTH - 3.0 - x / 10.0, y) for y, x in goals],
        longest,
        sharp,
    ),
    st.lists(st.tuples(within(30.0, 90.0), within(0.0, 80.0), st.just(8.0)), max_size=8),
    st.lists(places, min_size=1, max_size=3, unique=True),
    st.lists(places, min_size=1, max_size=3, unique=True),
    st.floats(110.0, 200.0),
    st.floats(0.2, 3.0),
)


@pytest.mark.parametrize("name", ["vd", "vdp-pio", "vdp"])
@settings(max_examples=15)
@given(found=fleets, seed=st.integers(0, 1000))
def test_paths_keep_what_they_promise_on_any_map(name, found, seed):
    plan = plan_with(planner(name), found, seed)
    if not plan.paths:
        assert plan.outcome in (NO_PATH, NOT_FOUND)
        assert plan.reason
        return
    starts, goals = [[tuple(place) for place in ends] for ends in (found.starts, found.goals)]
    begun, ended = [starts.index(tuple(path.xy[0])) for path in plan.paths], [tuple(path.xy[-1]) for path in plan.paths]
    assert begun == sorted(set(begun))
    assert len(set(ended)) == len(ended)
    assert set(ended) <= set(goals)
    turns_told = any("turn limit" in note for note in plan.notes)
    for path in plan.paths:
        assert room(found, path) >= UNIT - 1e-6
        assert path.length <= found.max_range * (1.0 + 1e-9)
        assert sharpest(path) <= found.max_turn_angle + 1e-6 or (turns_told and name == "vd")
    assert len(plan.paths) == len(starts) or any("no path" in note for note in plan.notes)
    assert [stage.paths for stage in plan.stages][-1] == plan.paths


@pytest.mark.parametrize("name", FLEETS)
def test_more_aircraft_than_targets_leave_some_and_say_so(name):
    found = fleet([], [(5.0, 20.0), (5.0, 40.0), (5.0, 60.0)], [(115.0, 60.0), (115.0, 20.0)])
    plan = plan_with(planner(name), found, 0)
    assert [path.name for path in plan.paths] == ["aircraft 1 to target 2", "aircraft 3 to target 1"]
    assert plan.notes == (
        "aircraft 2 has no path: there are fewer targets than aircraft; paths are numbered on without",
    )


@pytest.mark.parametrize("name", FLEETS)
def test_a_start_that_is_a_goal_of_the_fleet_is_bad_input(name):
    with pytest.raises(InputError, match="its start 2 is its goal 1"):
        plan_with(planner(name), fleet([], [(5.0, 20.0), (5.0, 40.0)], [(5.0, 40.0), (9.0, 9.0)]), 0)


@pytest.mark.parametrize("name", FLEETS)
def test_a_start_of_the_fleet_in_a_hazard_is_named(name):
    with pytest.raises(InputError, match=r"sample: start 2: .* deep in what is forbidden"):
        plan_with(planner(name), fleet([(5.0, 40.0, 3.0)], [(5.0, 20.0), (5.0, 40.0)], [(99.0, 9.0)]), 0)


@pytest.mark.parametrize("name", ["vd", "vdp"])
@pytest.mark.parametrize("hazards", [0, 1, 2])
def test_few_hazards_are_enough(name, hazards):
    """Round a hazard of radius 10 that stands in the way, kept one unit clear of."""
    circles = [(60.0, 40.0, 10.0), (30.0, 70.0, 10.0)][:hazards]
    plan = plan_with(planner(name), fleet(circles, [(5.0, 40.0)], [(115.0, 40.0)]), 0)
    assert 110.0 <= plan.paths[0].length / UNIT <= (115.0 if hazards else 110.0 + 1e-9)


@pytest.mark.parametrize("name", ["vd", "vdp"])
def test_beyond_the_range_nothing_is_found(name):
    plan = plan_with(planner(name), fleet([(60.0, 40.0, 10.0)], [(5.0, 40.0)], [(115.0, 40.0)], max_range=110.5), 0)
    assert (plan.outcome, plan.paths) == (NOT_FOUND, ())


@pytest.mark.parametrize("name", ["vd", "vdp"])
def test_a_larger_map_with_a_larger_clearance_has_the_same_paths(name):
    settings = {**FLEETS[name], "clearance": 250.0}
    large = plan_with(make_planner(name, settings), MARS, 3)
    small = plan_with(make_planner(name, {**settings, "clearance": 1.0}), scaled(MARS, 1.0), 3)
    for one, other in zip(large.paths, small.paths, strict=True):
        assert one.xy / 250.0 == pytest.approx(other.xy, rel=1e-6)


def test_hazards_that_overlap_all_across_leave_no_path():
    wall = [Circle(60.0 * UNIT, y * UNIT, 6.0 * UNIT) for y in np.arange(0.0, 81.0, 8.0)]
    found = fleet([], [(5.0, 40.0)], [(115.0, 40.0)])
    found = replace(found, map=replace(found.map, circles=tuple(wall)))
    assert {plan_with(planner(name), found, 0).outcome for name in FLEETS} == {NO_PATH}
