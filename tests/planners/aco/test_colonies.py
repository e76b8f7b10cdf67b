"""Paper 000's colonies on our map of its size, and on the slalom. Seeds from 100 on were not used for tuning."""

import numpy as np
import pytest

from planners.all_planners import make_planner, plan_with
from planners.facts import exact_length, turn_angle
from planners.planner import NOT_FOUND
from planners.scenario import load_scenario
from sample_maps import scenario

EXACT = 1192.21  # map units, by visibility graph for a point
NOFLY, SLALOM = load_scenario("nofly-1000x660"), load_scenario("slalom-1000x600")
RADIUS = 33.0  # map units: a c172x at 55 m/s and 25 deg of bank, at 20 m a unit


@pytest.mark.parametrize("seed", [100, 101, 102])
def test_the_improved_colony_does_what_the_paper_claims(seed):
    plan = plan_with(make_planner("aco-improved"), NOFLY, seed)
    path, history = plan.paths[0], plan.history
    assert path.length / NOFLY.unit <= 1.020 * EXACT  # the paper: 1222.27, 1.025 of it
    assert history.survivors[-1] == 100
    assert history.converged <= 5  # the paper: 10
    assert np.degrees(turn_angle(path, 5.0 * NOFLY.unit)) <= 8.72
    assert np.degrees(turn_angle(path, NOFLY.unit)) <= 2.0
    assert plan.smallest_radius >= RADIUS * NOFLY.unit
    assert plan.notes == ()


def test_the_basic_colony_turns_by_135_degrees_as_the_paper_says():
    plan = plan_with(make_planner("aco-basic"), NOFLY, 101)
    assert np.degrees(np.abs(plan.paths[0].turns).max()) == pytest.approx(135.0)
    assert 1.2 * EXACT < plan.paths[0].length / NOFLY.unit < 2.0 * EXACT  # the paper: 1726.29


@pytest.mark.parametrize("seed", [100, 101])
def test_as_printed_the_basic_colony_sends_no_ant_to_the_goal(seed):
    plan = plan_with(make_planner("aco-basic-printed", {"iterations": 3}), NOFLY, seed)
    assert plan.outcome == NOT_FOUND
    assert "none of 100 ants arrived in any of 3 iterations" in plan.reason
    assert plan.history.survivors.tolist() == [0, 0, 0]


@pytest.mark.parametrize("found", [NOFLY, SLALOM], ids=["nofly", "slalom"])
def test_turn_aware_ants_keep_the_radius_and_stay_near_the_shortest(found):
    planner = make_planner("aco-turn-aware")
    plan = plan_with(planner, found, 100)
    assert plan.smallest_radius >= 661.0
    assert plan.paths[0].length <= 1.02 * exact_length(found, planner.clearance)
    assert plan.history.survivors[-1] >= 90


def test_in_the_slalom_the_improved_colony_asks_for_turns_that_no_c172x_makes():
    plan = plan_with(make_planner("aco-improved"), SLALOM, 100)
    assert plan.smallest_radius < RADIUS * SLALOM.unit
    assert "pulled back to a radius of" in plan.notes[0]


def test_nodes_alone_starve_the_colony():
    """As in reproduction: 0 to 28 of 100 survive where pheromone lies on nodes only, 100 where it lies on cells."""
    plan = plan_with(make_planner("aco-improved", {"pheromone_on": "nodes", "smoothing": False}), NOFLY, 100)
    assert plan.history.survivors[-1] < 50


def test_the_alert_zone_changes_nothing_but_time():
    one, two = (
        plan_with(make_planner("aco-improved", {"alert_zone": zone, "iterations": 2}), NOFLY, 5)
        for zone in (True, False)
    )
    assert one.paths[0].points.tobytes() == two.paths[0].points.tobytes()


def test_eq_6_gives_the_step_from_the_number_of_steps():
    """1104.54 / 139 is 7.95, and so 8 cells."""
    eight, by_number = (
        plan_with(make_planner("aco-improved", {**setting, "iterations": 2, "smoothing": False}), NOFLY, 5)
        for setting in ({"step": 8}, {"steps": 139})
    )
    assert eight.paths[0].points.tobytes() == by_number.paths[0].points.tobytes()


def test_eq_5_makes_the_cells_smaller_where_obstacles_ask_for_it():
    coarse, fine = (
        make_planner("aco-improved", {"cell": 8.0, "cover": cover}).ground(NOFLY).cell for cover in (0.5, 0.95)
    )
    assert coarse == 8.0 * NOFLY.unit
    assert fine < coarse


def test_a_vehicle_that_cannot_turn_in_the_map_finds_nothing():
    """A bend of 90 deg in a corridor 12 wide, for a radius of 60."""
    bend = scenario(
        polygons=[[(0.0, 12.0), (100.0, 12.0), (100.0, 80.0), (0.0, 80.0)]], start=(5.0, 6.0), goal=(110.0, 75.0)
    )
    plan = plan_with(make_planner("aco-turn-aware", {"turn_radius": 1200.0, "clearance": 0.0, "ants": 20}), bend, 0)
    assert plan.outcome == NOT_FOUND
