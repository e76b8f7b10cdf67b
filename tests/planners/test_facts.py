import math
from dataclasses import replace

import msgspec
import numpy as np
import pytest

from grid_maps import on_cells
from planners.all_planners import make_planner, plan_with
from planners.errors import TrackworthyError
from planners.exact import Exact
from planners.facts import PlanFacts, exact_length, facts_of, turn_angle
from planners.path import Path
from planners.planner import NO_PATH
from planners.scenario import load_scenario
from sample_maps import ONE_CIRCLE, UNIT, WALLED, scenario


def told(name, found, seed=1, **settings):
    planner = make_planner(name, settings)
    return facts_of(plan_with(planner, found, seed), planner, found, seed)


@pytest.mark.parametrize("spacing", [1.0, 5.0])
def test_the_turn_angle_of_a_circle_depends_on_its_sampling(spacing):
    """Chords of length s on radius R turn by 2 asin(s / 2R): 8.72 deg say nothing without s."""
    bearing = np.linspace(0.0, 65.0 / 33.0, 20_001)
    path = Path(33.0 * np.column_stack([np.cos(bearing), np.sin(bearing)]))
    assert turn_angle(path, spacing) == pytest.approx(2.0 * math.asin(spacing / 66.0), rel=0.02)


def test_the_exact_path_is_its_own_yardstick():
    found = told("exact", ONE_CIRCLE, clearance=20.0)
    assert found.length_ratio == 1.0
    assert found.clearance_min == pytest.approx(20.0, abs=1e-3)
    assert found.smallest_radius is None
    assert (found.population, found.best, found.converged) == (0, (), None)


def test_a_colony_tells_of_its_search():
    found = told("aco-improved", ONE_CIRCLE, ants=20, iterations=3, turn_radius=100.0)
    assert found.length_ratio > 1.0
    assert found.smallest_radius >= 100.0
    assert found.clearance_min >= 20.0
    assert (found.population, len(found.best), len(found.mean), len(found.survivors)) == (20, 3, 3, 3)
    assert msgspec.json.decode(msgspec.json.encode(found), type=PlanFacts) == found


def test_where_there_is_no_path_it_says_why():
    found = told("aco-basic", WALLED)
    assert found.outcome == NO_PATH
    assert "no free cells lead from the start to the goal" in found.reason
    assert (found.length, found.exact_length, found.length_ratio) == (None, None, None)


def test_a_yardstick_that_fails_costs_no_plan(monkeypatch):
    def fails(*_):
        raise TrackworthyError("rounding")

    monkeypatch.setattr(Exact, "plan", fails)
    assert exact_length(scenario(), 7.0 * UNIT) is None


def test_a_raster_too_fine_for_the_yardstick_has_none():
    cells = np.zeros((145, 145), dtype=bool)
    cells[1::2, 1::2] = True  # 72 x 72 of four edges each
    found = on_cells(cells, (0, 0), (0, 144))
    known = told("astar-eight", found)
    assert known.length == pytest.approx(144.0)
    assert (known.exact_length, known.length_ratio) == (None, None)


def test_a_fleet_of_which_some_stay_is_not_compared_with_one_that_flies_whole():
    """The third aircraft's shortest path, 179 units, is within a range of 200; those of the others are not."""
    fleet = replace(load_scenario("mars-hazards-15"), max_range=200.0 * 250.0)
    some = told("vd", fleet)
    assert len(some.lengths) == 1
    assert (some.exact_length, some.length_ratio) == (None, None)


def test_of_a_fleet_lengths_are_summed_and_the_rest_is_the_worst():
    fleet = load_scenario("mars-hazards-15")
    found = told("exact", fleet, clearance=fleet.unit)
    assert found.length == pytest.approx(sum(found.lengths))
    assert found.longest == max(found.lengths)
    assert (len(found.lengths), found.length_ratio) == (3, 1.0)
    assert found.clearance_min == pytest.approx(fleet.unit, rel=1e-3)
    assert found.stages == ()
