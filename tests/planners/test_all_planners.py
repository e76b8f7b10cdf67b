"""What holds for every planner."""

import dataclasses

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.all_planners import ALL_PLANNERS, make_planner, plan_with
from planners.errors import InputError
from planners.planner import NO_PATH, NOT_FOUND
from planners.scenario import load_scenario
from sample_maps import FREE, GATE, ONE_CIRCLE, UNIT, WALLED, box, room, scenario, scenarios

NAMES = [planner.name for planner in ALL_PLANNERS]
COLONIES = [name for name in NAMES if name.startswith("aco-")]
ROADMAPS = [name for name in NAMES if name.startswith("vd")]
TRUCKS = ["astar-arc"]  # of one size
SLOW = [*ROADMAPS, *TRUCKS]
PRINTED = ("aco-basic-printed", "astar-arc-paper")  # as their papers print them, and may find nothing
FINDING = [name for name in NAMES if name not in PRINTED]
SMALL = {"turn_radius": 5.0 * UNIT, "ants": 20, "iterations": 4, "max_range": 1000.0, "pigeons": 40}
COARSE = {"cell": 0.1}  # where a cell is a share of the vehicle; colonies keep their own cells, of 1 or 4
SMALL |= {"compass_iterations": 20, "landmark_iterations": 5}


def small(name, **more):
    """The planner with a colony and a radius for small maps, as far as it has such settings."""
    known = {field.name for field in msgspec.structs.fields(next(one for one in ALL_PLANNERS if one.name == name))}
    if "links" in known:
        more = {"clearance": 20.0} | more
    if name not in COLONIES:
        more = COARSE | more
    return make_planner(name, {key: value for key, value in (SMALL | more).items() if key in known})


def check(plan, planner, found):
    """A plan is a path that keeps its clearance, or says why there is none."""
    if not plan.paths:
        assert plan.outcome in (NO_PATH, NOT_FOUND)
        assert plan.reason
        assert "\n" not in plan.reason
        return
    path = plan.paths[0]
    assert (path.xy[0] == found.starts[0]).all()
    assert (path.xy[-1] == found.goals[0]).all()
    assert room(found, path) >= planner.clearance - 1e-6
    if plan.polylines:
        assert room(found, plan.polylines[0]) >= planner.clearance - 1e-6
    assert (plan.outcome, plan.reason) == ("", "")


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("found", [FREE, ONE_CIRCLE, GATE], ids=["free", "circle", "gate"])
def test_paths_lead_from_start_to_goal_and_keep_their_clearance(name, found):
    planner = small(name)
    plan = plan_with(planner, found, 1)
    check(plan, planner, found)
    if name in FINDING:
        assert len(plan.paths) == 1


@pytest.mark.parametrize("name", NAMES)
def test_where_a_wall_stands_between_there_is_no_path(name):
    plan = plan_with(small(name), WALLED, 1)
    assert plan.paths == ()
    assert plan.outcome == NO_PATH


@pytest.mark.parametrize("name", [name for name in NAMES if name not in SLOW])
@settings(max_examples=150)
@given(found=scenarios, seed=st.integers(0, 1000))
def test_no_path_collides_on_any_map(name, found, seed):
    collides_nowhere(name, found, seed)


@pytest.mark.parametrize("name", SLOW)
@settings(max_examples=20)
@given(found=scenarios, seed=st.integers(0, 1000))
def test_no_path_of_a_slow_planner_collides_on_any_map(name, found, seed):
    collides_nowhere(name, found, seed)


def collides_nowhere(name, found, seed):
    planner = small(name)
    try:
        plan = plan_with(planner, found, seed)
    except InputError:
        return  # its start or its goal is not free
    check(plan, planner, found)


@pytest.mark.parametrize("name", FINDING)
def test_a_seed_decides_the_path(name):
    one, two = (plan_with(small(name), ONE_CIRCLE, 7) for _ in range(2))
    assert one.paths[0].points.tobytes() == two.paths[0].points.tobytes()
    if one.history is not None and one.history.swarms:
        assert one.history.swarms[-1].points.tobytes() == two.history.swarms[-1].points.tobytes()


@pytest.mark.parametrize("name", [name for name in FINDING if name not in TRUCKS])
def test_a_larger_map_with_a_larger_vehicle_has_the_same_path(name):
    once = scenario(circles=[(60.0, 40.0, 20.0)], unit=1.0)
    path = plan_with(small(name), ONE_CIRCLE, 3).paths[0]
    shrunk = plan_with(small(name, clearance=small(name).clearance / UNIT, turn_radius=5.0), once, 3).paths[0]
    assert shrunk.length * UNIT == pytest.approx(path.length, rel=1e-9)


@pytest.mark.parametrize("name", [name for name in FINDING if name in COLONIES])
def test_a_colony_goes_on_where_all_pheromone_has_evaporated(name):
    assert plan_with(small(name, evaporation=1.0), GATE, 1).paths


@pytest.mark.parametrize("name", [name for name in FINDING if name != "exact"])
def test_no_ant_goes_beyond_the_scenarios_range(name):
    short = dataclasses.replace(ONE_CIRCLE, max_range=112.0 * UNIT)  # the straight way is 110, and not free
    assert plan_with(small(name), short, 1).outcome == NOT_FOUND


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("place", ["start", "goal"])
def test_a_place_in_an_obstacle_is_bad_input(name, place):
    found = scenario(circles=[(20.0, 40.0, 10.0)], **{place: (22.0, 41.0)})
    with pytest.raises(InputError, match=rf"sample: {place}"):
        plan_with(small(name), found, 0)


@pytest.mark.parametrize("name", NAMES)
def test_a_start_that_is_the_goal_is_bad_input(name):
    with pytest.raises(InputError, match="its start is its goal"):
        plan_with(small(name), scenario(start=(50.0, 40.0), goal=(50.0, 40.0)), 0)


@pytest.mark.parametrize("name", COLONIES)
def test_a_fleet_is_bad_input_to_colonies(name):
    with pytest.raises(InputError, match=f"3 starts and 3 goals, and {name} plans from one to one"):
        plan_with(small(name), load_scenario("mars-hazards-15"), 0)


@pytest.mark.parametrize("name", NAMES)
def test_histories_agree_with_themselves(name):
    history = plan_with(small(name), GATE, 2).history
    if history is None:
        return
    assert len(history.best) == len(history.mean) == len(history.survivors)
    if name in ROADMAPS:
        assert len(history.evaluations) == len(history.cost) == len(history.best)
        assert (np.diff(history.evaluations) > 0).all()
        assert (np.diff(history.cost) <= 0.0).all()
        assert (history.survivors <= history.population).all()
        return
    assert len(history.swarms) == len(history.best)
    for swarm, best, survivors in zip(history.swarms, history.best, history.survivors, strict=True):
        assert len(swarm.alive) == len(swarm.first) - 1 == history.population
        assert swarm.alive.sum() == survivors
        lengths = [
            np.hypot(*np.diff(swarm.points[a:b], axis=0).T).sum()
            for a, b, alive in zip(swarm.first, swarm.first[1:], swarm.alive, strict=False)
            if alive
        ]
        assert min(lengths, default=np.nan) == pytest.approx(best, nan_ok=True)


def test_an_unknown_planner_or_setting_names_the_nearest():
    with pytest.raises(InputError, match="did you mean 'aco-improved'"):
        make_planner("aco-improvd")
    with pytest.raises(InputError, match="did you mean 'ants'"):
        make_planner("aco-improved", {"ant": 3})


@pytest.mark.parametrize(
    "setting", [{"ants": 0}, {"ants": 1.5}, {"bias": 1.5}, {"cell": 0.0}, {"clearance": -1.0}, {"cell": float("nan")}]
)
def test_an_impossible_setting_is_bad_input(setting):
    with pytest.raises(InputError, match=f"planner aco-improved: {next(iter(setting))}"):
        make_planner("aco-improved", setting)


def test_a_grid_beyond_all_memory_is_bad_input():
    with pytest.raises(InputError, match="give larger cells"):
        plan_with(make_planner("aco-improved", {"cell": 1e-4}), FREE, 0)


def test_a_corridor_of_two_cells_is_planned_through():
    corridor = scenario(polygons=[box(0.0, 45.0, 120.0, 30.0), box(0.0, 5.0, 120.0, 30.0)])
    for name in FINDING:
        planner = small(name)
        plan = plan_with(planner, corridor, 1)
        check(plan, planner, corridor)
        assert plan.paths
