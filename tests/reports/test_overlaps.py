"""Every kind of figure: all that is written on it can be read, whatever it shows."""

import dataclasses
from functools import cache

import numpy as np
import pytest
from matplotlib.figure import Figure
from overlaps import faults

from planners.all_planners import make_planner, plan_with
from planners.planner import History, Stage
from planners.scenario import load_scenario
from reports.figures.colony_figure import colony_figure
from reports.figures.comparison_figure import comparison_figure
from reports.figures.convergence_figure import convergence_figure
from reports.figures.fleet_figure import fleet_figure
from reports.figures.fleet_plan_figure import fleet_plan_figure
from reports.figures.plan_figure import plan_figure
from reports.figures.roadmap_figure import roadmap_figure
from reports.figures.routes_figure import Route, routes_figure
from reports.figures.sector_figure import sector_figure
from reports.figures.segmentation_figure import segmentation_figure
from reports.figures.style import style
from reports.figures.track_figure import track_figure
from reports.figures.trials_figure import trials_figure
from reports.figures.versus_figure import versus_figure
from sample_maps import box, scenario
from sample_plans import lost_plan, made_up_plan

from .conftest import cut, make_fleet, make_route, make_yard
from .many_cases import result_like
from .test_fleet_plans import search
from .test_segmentation import made_up
from .test_versus import only_family, results

LONG = "a-name-of-a-hundred-characters-without-a-space-" * 3


def long_named(outcome):
    return dataclasses.replace(outcome, name=LONG, vehicle="a-vehicle-with-a-long-name")


RUNS = {
    "40 km": make_route,
    "70 m": make_yard,
    "sharp": lambda: make_yard(sharp=True),
    "long name": lambda: long_named(make_yard(sharp=True)),
    "two samples": lambda: cut(make_route(dt=1.0), [0, 1]),
    "fleet": make_fleet,
}


@cache
def run(kind):
    return RUNS[kind]()


@pytest.mark.parametrize("page", [False, True])
@pytest.mark.parametrize("kind", RUNS)
def test_runs(kind, page):
    outcome = run(kind)
    with style():
        assert faults(track_figure(outcome, page, "worst of 20: trial 7")) == []
        if outcome.fleet is not None:
            assert faults(fleet_figure(outcome, page)) == []


@pytest.mark.parametrize("kind", RUNS)
def test_trials(kind):
    outcome = run(kind)
    with style():
        assert faults(trials_figure(result_like(outcome, trials=9, bad=3), outcome)) == []


@pytest.fixture(scope="module")
def nofly():
    return load_scenario("nofly-1000x660")


@pytest.fixture(scope="module")
def mars():
    return load_scenario("mars-hazards-15")


@pytest.mark.parametrize("name", ["improved", LONG])
def test_searches(nofly, name):
    plan = made_up_plan(iterations=12, ants=3)
    with style():
        for plans in ({name: plan}, {name: plan, f"{name} again": plan}, {name: lost_plan()}):
            assert faults(plan_figure(nofly, plans)) == []
        assert faults(comparison_figure({name: plan.history, "other": plan.history}, 24e3)) == []
        assert faults(colony_figure(nofly, plan.history)) == []


def test_plans_of_fleets(mars):
    vd = plan_with(make_planner("vd", {}), mars, 0)
    steps = np.arange(1, 11)
    best = 180e3 - 500.0 * steps
    history = History(best, best + 5e3, steps, 30, evaluations=100 * steps, cost=best)
    searched = dataclasses.replace(vd, history=history, stages=(*vd.stages, Stage("GCCPIO", vd.paths)))
    with style():
        assert faults(fleet_plan_figure(mars, "vd", vd, 250.0)) == []
        assert faults(fleet_plan_figure(mars, LONG, searched, 250.0)) == []
        assert faults(roadmap_figure(mars, searched, 250.0)) == []


def test_routes_and_sectors():
    wall = scenario(polygons=[box(55.0, 20.0, 4.0, 40.0)], unit=1.0)
    printed = {f"{kmh} km/h": make_planner("astar-arc-paper", {"speed": f"{kmh}km/h"}) for kmh in (30, 45, 60)}
    rows = [[Route(name, plan_with(planner, wall, 0), 9.0) for name, planner in printed.items()]]
    with style():
        assert faults(routes_figure(wall, rows)) == []
        assert faults(sector_figure(wall, printed)) == []


def test_cases_side_by_side_and_searches_over_seeds():
    facts = [search((None, 172e3 + 100.0 * k, 171e3 + 100.0 * k), (100, 200, 30_000)) for k in range(5)]
    with style():
        assert faults(versus_figure(only_family(results()))) == []
        assert faults(convergence_figure({"vdp-pio": facts, "vdp": facts}, 170.9e3)) == []


@pytest.mark.parametrize(("rows", "columns"), [(40, 60), (20, 120), (120, 20)])
def test_segmentations(rows, columns):
    aerial, blocked, facts, truth = made_up(rows, columns)
    with style():
        assert faults(segmentation_figure(aerial, blocked, facts, truth)) == []


def test_the_check_finds_what_cannot_be_read():
    """Two texts on one place, one that runs out of the figure, and one too small."""
    figure = Figure(figsize=(4.0, 2.0))
    figure.text(0.1, 0.5, "one text")
    figure.text(0.12, 0.52, "another")
    figure.text(0.9, 0.2, "runs out of the figure")
    figure.text(0.1, 0.1, "small", fontsize=5.0)
    found = faults(figure)
    assert "'one text' lies on 'another'" in found
    assert "'runs out of the figure' leaves the figure" in found
    assert "'small' is of 5.0 pt" in found
    assert len(found) == 3
