"""What is told and drawn of the plans of fleets."""

import dataclasses
import json
import re

import numpy as np
import pytest

from campaigns.claims import Beside, Claim
from campaigns.plan_statistics import PlannedBy, PlanStatistics, Spread
from planners.all_planners import make_planner, plan_with
from planners.exact import Exact
from planners.facts import PlanFacts, facts_of
from planners.path import Path
from planners.planner import NO_PATH, History, Plan, Stage
from planners.scenario import load_scenario
from planners.voronoi.roadmap import roadmap_of
from planners.voronoi.vd import Vd
from reports.figures.convergence_figure import best_at, convergence_figure, spread
from reports.figures.fleet_plan_figure import fleet_plan_figure, pair_of
from reports.figures.plan_figure import save_plan_figure
from reports.figures.roadmap_figure import has_roadmap, roadmap_figure
from reports.figures.style import MEMBERS, style
from reports.files.plan_json import plan_json
from reports.pages.plan_rows import is_fleet, limits, plan_row
from reports.terminal.plan_table import rows
from small_reports import pdf_of, save_figure, sections_of

TOLD = PlanStatistics(
    seeds=4, found=4, missing={}, exact_length=172000.0, length=Spread(172600.0, 173000.0),
    length_ratio=Spread(1.0035, 1.0058), turn_1_deg=15.0, turn_5_deg=16.0, cornered=4, paths=3,
    longest=Spread(65250.0, 110000.0), turn_max_deg=16.1, stages=(("Voronoi roadmap", 221475.0), ("GCCPIO", 172600.0)),
)  # fmt: skip
CLAIM = Claim(
    planner="vd", scenario="mars-hazards-15", source="paper 1", length=763.9, longest=282.6, turn=83.1,
    beside=Beside(roadmap="Fig. 1"),
)  # fmt: skip


@pytest.fixture(scope="module")
def mars():
    return load_scenario("mars-hazards-15")


@pytest.fixture(scope="module")
def vd(mars):
    return plan_with(make_planner("vd", {}), mars, 0)


@pytest.fixture(scope="module")
def searched(vd):
    """That plan after a made-up search."""
    steps = np.arange(1, 11)
    best = np.where(steps < 3, np.nan, 180e3 - 500.0 * steps)
    history = History(best, best + 5e3, steps, 30, evaluations=100 * steps, cost=best)
    return dataclasses.replace(vd, history=history, stages=(*vd.stages, Stage("GCCPIO", vd.paths)))


def words(figure):
    return "\n".join(text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text")))


def inside(figure):
    drawn = figure.get_tightbbox()
    assert drawn.x0 >= 0.0
    assert drawn.y0 >= 0.0
    assert drawn.x1 <= figure.get_size_inches()[0]
    assert drawn.y1 <= figure.get_size_inches()[1]


def test_a_row_has_sum_longest_path_and_steps_and_what_is_over_a_limit(mars):
    row = plan_row(PlannedBy(Vd(), mars, 1, "case", TOLD, (CLAIM,)), "vd")
    assert row["length"] == ["690.4", "692"]
    assert row["longest"] == ["261", "440"]
    assert (row["corner"], row["over"]) == ("16.1°", ["range"])
    assert row["stages"] == "Voronoi roadmap 885.9 → GCCPIO 690.4 map units, medians"
    assert (row["claims"][0]["longest"], row["claims"][0]["turn"]) == ("282.6", "83.1°")
    sharp = dataclasses.replace(mars, max_turn_angle=0.1, max_range=None)
    assert plan_row(PlannedBy(Vd(), sharp, 1, "case", TOLD), "vd")["over"] == ["turn"]


def test_the_limits_of_a_scenario_are_told(mars):
    assert is_fleet(mars)
    assert limits(mars) == "range limit 424 map units a path, turn limit 45° at a vertex"
    assert limits(load_scenario("target-vehicle-71m")) == ""
    assert not is_fleet(load_scenario("nofly-1000x660"))


def test_terminal_and_json_tell_every_path(mars, vd):
    facts = facts_of(vd, Vd(), mars, 0)
    told = {name: units for name, _, units in rows(facts)}
    assert float(told["sum of the paths"]) == pytest.approx(sum(float(told[f"path {i}"]) for i in (1, 2, 3)), abs=0.01)
    assert float(told["after line of sight"]) == float(told["sum of the paths"])
    assert float(told["after Voronoi roadmap"]) > float(told["sum of the paths"])
    parsed = json.loads(plan_json(facts, vd))
    assert [path["name"] for path in parsed["paths"]] == [path.name for path in vd.paths]
    assert parsed["path"] == parsed["paths"][0]["points"]


def test_each_path_is_drawn_in_the_colour_of_its_aircraft(mars, vd):
    with style():
        figure = fleet_plan_figure(mars, "vd", vd, 250.0)
    for path in vd.paths:
        colour = MEMBERS[pair_of(mars, path)[0]]
        assert any(
            line.get_color() == colour and np.array_equal(line.get_xydata(), path.xy) for line in figure.axes[0].lines
        )


def test_an_aircraft_keeps_its_number_where_another_has_no_path(mars, vd):
    some = dataclasses.replace(vd, paths=vd.paths[1:], stages=())
    assert [pair_of(mars, path)[0] for path in some.paths] == [1, 2]
    with style():
        told = words(fleet_plan_figure(mars, "vd", some, 250.0))
    assert "2 to target" in told
    assert "1 to target" not in told


@pytest.mark.parametrize("kind", ["vd", "searched", "none"])
def test_the_figure_of_a_plan(kind, mars, vd, searched):
    plan = {"vd": vd, "searched": searched, "none": Plan(outcome=NO_PATH, reason="walled in")}[kind]
    with style():
        figure = fleet_plan_figure(mars, "planner", plan, 250.0)
        inside(figure)
    told = words(figure)
    parts = ("times the exact shortest sum", "of at most 424 map units; largest turn", "of at most 45°",
             "Voronoi roadmap", "Sharpest turn", "1 to target", "start", "exact shortest, 250 m clear")  # fmt: skip
    for part in parts if plan.paths else ("no path: walled in",):
        assert part in told
    assert ("Best sum [km]" in told) == (kind == "searched")


def test_maps_of_any_shape_and_number(mars):
    places = np.array([[50.0, 20.0], [900.0, 20.0], [500.0, 80.0]])
    for size in ((1000.0, 100.0), (100.0, 1000.0)):
        along = places if size[0] > size[1] else places[:, ::-1]
        area = dataclasses.replace(mars.map, circles=(), bounds=(0.0, 0.0, *size))
        odd = dataclasses.replace(mars, map=area, size=size, unit=1.0, starts=along[:2], goals=along[2:])
        with style():
            inside(fleet_plan_figure(odd, "a", Plan(paths=(Path(along[[0, 2]]),)), 0.0))


def test_the_roadmap_is_drawn_edge_by_edge(mars, vd, searched):
    roadmap = roadmap_of(mars, 250.0)
    for plan in (vd, searched):
        assert has_roadmap(plan)
        with style():
            figure = roadmap_figure(mars, plan, 250.0)
            inside(figure)
        assert sum(len(lines.get_segments()) for lines in figure.axes[0].collections) == len(roadmap.edges)
        assert f"{len(roadmap.vertices)} vertices, {len(roadmap.edges)} edges" in words(figure)
    assert not has_roadmap(Plan(paths=vd.paths))


def search(best, evaluations, unit=250.0):
    return PlanFacts(planner="p", scenario="s", seed=1, map_unit=unit, best=best, evaluations=evaluations)


def test_the_best_after_so_many_evaluations():
    facts = search((None, 9.0, 7.0), (10, 20, 30))
    assert best_at(facts, np.array([0.0, 9.0, 10.0, 19.0, 20.0, 29.0, 30.0, 99.0])) == pytest.approx(
        [np.nan] * 4 + [9.0, 9.0, 7.0, 7.0], nan_ok=True
    )


def test_a_seed_without_a_path_counts_as_the_worst():
    low, middle, high = spread(np.array([[1.0], [2.0], [np.nan]]))
    assert (low[0], middle[0], high[0]) == (1.0, 2.0, np.inf)


def test_convergence_shows_median_and_band(tmp_path):
    searches = {
        name: [search((None, 172e3 + 100.0 * k + gain, 171e3 + 100.0 * k), (100, 200, last)) for k in range(10)]
        for name, gain, last in (("vdp-pio", 900.0, 300), ("vdp", 400.0, 30_000))
    }
    with style():
        figure = convergence_figure(searches, 170.9e3)
        inside(figure)
    told = words(figure)
    for part in ("vdp-pio, 10 seeds", "10 to 90 % of seeds", "exact shortest", "[thousands]", "Best sum so far"):
        assert part in told
    median = figure.axes[0].lines[1].get_ydata()
    assert np.nanmin(median) == pytest.approx((171e3 + 400.0) / 250.0)
    for file in ("a.png", "b.png"):
        save_figure(convergence_figure, searches, file=tmp_path / file)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def test_the_same_plan_is_the_same_bytes(mars, searched, tmp_path):
    for file in ("a.svg", "b.svg"):
        save_plan_figure(mars, {"vdp": searched}, tmp_path / file, 250.0)
        save_figure(roadmap_figure, mars, searched, 250.0, file=tmp_path / f"roadmap-{file}")
    for stem in ("", "roadmap-"):
        assert (tmp_path / f"{stem}a.svg").read_bytes() == (tmp_path / f"{stem}b.svg").read_bytes()


def test_a_section_of_fleets(mars, searched, fleet, tmp_path, monkeypatch):
    plans = {"vd": searched, "exact": Exact(clearance=250.0).plan(mars, np.random.default_rng(0))}
    monkeypatch.setattr("reports.pages.pdf_plans.plan_with", lambda planner, *_: plans[planner.name])
    searches = tuple(search((180e3, 175e3), (100, last)) for last in (200, 300))
    told = [
        PlannedBy(Vd(), mars, 1, "case", TOLD, (CLAIM,), searches),
        PlannedBy(Exact(clearance=250.0), mars, 1, "other", TOLD),
    ]
    (section,) = sections_of(told)
    stem = "plans-1-mars-hazards-15"
    assert [picture.stem for picture in section.pictures] == [
        f"{stem}-{name}" for name in ("roadmap", "convergence", "vd", "exact")
    ]
    assert section.pictures[0].caption.endswith("Beside Fig. 1.")
    assert "10 to 90 % over 2 seeds" in section.pictures[1].caption
    assert section.fleet
    assert re.search(r"exact shortest sum 688 map units .*; range limit 424", section.about)
    pdf_of([], tmp_path / "a.pdf", "Plans", plans=[section])
    assert len(re.findall(rb"/Type\s*/Page\b", (tmp_path / "a.pdf").read_bytes())) == 3
