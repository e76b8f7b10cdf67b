"""The report's section on plans: its table, its pictures, its pages."""

import dataclasses
import math
import re
from typing import ClassVar

import numpy as np
import pytest
from PIL import Image

from campaigns.case import Case
from campaigns.claims import Beside, Claim
from campaigns.plan_statistics import PlannedBy, PlanStatistics, Spread
from campaigns.statistics import statistics
from campaigns.summary import CaseResult
from planners.aco.improved import AcoImproved
from planners.exact import Exact
from planners.planner import NOT_FOUND
from planners.scenario import load_scenario
from reports.figures.plan_pictures import chosen_iterations
from reports.pages.plan_rows import changed, labels, plan_row, yardsticks
from sample_plans import lost_plan, made_up_history, made_up_plan
from small_reports import drawn, pdf_of, sections_of


class AcoLost(AcoImproved, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """It never arrives."""

    name: ClassVar[str] = "aco-lost"


FOUND = PlanStatistics(
    seeds=5, found=4, missing={NOT_FOUND: 1}, exact_length=24000.0, length=Spread(24080.4, 24444.0),
    length_ratio=Spread(1.00335, 1.0185), turn_1_deg=2.0, turn_5_deg=8.716, smallest_radius=662.0, population=100,
    iterations=10, survivors=99.5, converged=2.0,
)  # fmt: skip
LOST = PlanStatistics(seeds=3, found=0, missing={NOT_FOUND: 3}, population=5, iterations=3, survivors=0.0)
CORNERED = PlanStatistics(
    seeds=1, found=1, missing={}, exact_length=24000.0, length=Spread(24000.0, 24000.0), length_ratio=Spread(1.0, 1.0),
    turn_1_deg=31.4, turn_5_deg=29.2, cornered=1,
)  # fmt: skip
CLAIM = Claim(
    planner="aco-improved", source="paper 0, Table 2", length=1222.27, turn=8.72, iterations=10, survivors=(100, 100),
    beside=Beside(plan="Fig. 10", ants="Fig. 12", comparison="Fig. 15"),
)  # fmt: skip

NOTHING = {"g": "", "at": "", "over": False}


@pytest.fixture(scope="module")
def nofly():
    return load_scenario("nofly-1000x660")


def by(scenario, planner, statistics, case="case", claims=(), seed=7):
    return PlannedBy(planner, scenario, seed, case, statistics, claims)


def test_a_row_has_median_and_worst_in_map_units_and_its_claim_below(nofly):
    row = plan_row(by(nofly, AcoImproved(), FOUND, claims=(CLAIM,)), "aco-improved")
    assert (row["found"], row["missing"]) == ("4 of 5", "1 not found")
    assert row["length"] == ["1204.02", "1222.2"]
    assert row["ratio"] == ["1.003", "1.018"]
    straight = math.dist(nofly.starts[0], nofly.goals[0])
    assert [float(ratio) for ratio in row["straight"]] == [
        pytest.approx(length / straight, abs=1e-3) for length in (24080.4, 24444.0)
    ]
    assert row["driven"] == []
    assert row["needs"] == NOTHING
    assert row["turn"] == ["8.72°", "2°"]
    assert row["radius"] == ["662 m", "33.1 units"]
    assert (row["survivors"], row["converged"]) == ("99.5 of 100", "2 of 10")
    (claim,) = row["claims"]
    assert claim == {
        "source": "paper 0, Table 2", "length": "1222.27", "longest": "", "turn": "8.72°", "survivors": "100 of 100",
        "converged": "10", "straight": "", "needs": NOTHING,
    }  # fmt: skip


def test_what_is_missing_is_left_out(nofly):
    row = plan_row(by(nofly, AcoImproved(), LOST, claims=(Claim(planner="aco-improved", source="x"),)), "aco-improved")
    assert (row["found"], row["missing"], row["converged"]) == ("0 of 3", "3 not found", "")
    assert row["length"] == row["ratio"] == row["turn"] == row["radius"] == []
    (claim,) = row["claims"]
    assert claim.pop("source") == "x"
    assert claim.pop("needs") == NOTHING
    assert set(claim.values()) == {""}


def test_a_path_with_corners_has_no_radius(nofly):
    row = plan_row(by(nofly, Exact(20.0), CORNERED), "exact")
    assert (row["length"], row["radius"], row["survivors"]) == (["1200"], ["corners"], "")
    some = PlanStatistics(seeds=4, found=4, missing={}, cornered=1, smallest_radius=9.0)
    assert plan_row(by(nofly, Exact(), some), "exact")["radius"] == ["corners", "in 1"]


def test_planners_of_one_name_are_told_apart_by_their_settings(nofly):
    plans = [by(nofly, planner, FOUND) for planner in (Exact(), Exact(20.0), AcoImproved(taut=False, ants=50))]
    assert labels(plans) == ["exact, as by default", "exact, clearance = 20", "aco-improved"]
    assert changed(plans[2].planner) == "ants = 50, taut = false"
    assert yardsticks(plans) == "1200 map units with 0 m of clearance, 1200 map units with 20 m of clearance"


def test_iterations_shown_are_those_in_which_something_happens():
    assert chosen_iterations(made_up_history(10)) == (1, 3, 5, 10)
    assert chosen_iterations(made_up_history(4)) == (1, 3, 4)
    late = made_up_history(30)
    best, alive = np.array(late.best), np.array(late.survivors)
    best[:20], best[20:25], best[25:], alive[:20] = np.nan, 2e4, 1e4, 0
    assert chosen_iterations(dataclasses.replace(late, best=best, survivors=alive)) == (1, 21, 26, 30)
    assert chosen_iterations(lost_plan(30).history) == (1, 3, 10, 30)


@pytest.fixture
def sections(nofly, monkeypatch):
    """Of planners whose plans are made up."""

    def made(found, note="a note"):
        plans = {planner.name: plan for planner, plan, *_ in found}
        monkeypatch.setattr("reports.pages.pdf_plans.plan_with", lambda planner, *_: plans[planner.name])
        told = [by(nofly, planner, statistics, planner.name, claims) for planner, _, statistics, claims in found]
        return sections_of(told, [_result(name) for name in plans], note)

    return made


def _result(name):
    return CaseResult(1, Case(name=name, path="a.csv", vehicle="truck"), statistics([], {}), {})


def test_searches_have_their_ants_drawn_and_are_compared(sections, tmp_path):
    first = made_up_plan(iterations=4, ants=10)
    (section,) = sections([(AcoImproved(), first, FOUND, (CLAIM,)), (AcoLost(), lost_plan(), LOST, ())])
    names = [picture.stem for picture in section.pictures]
    stem = "plans-1-nofly-1000x660"
    assert names == [
        f"{stem}-{name}" for name in ("comparison", "aco-improved", "aco-lost", "aco-improved-ants", "aco-lost-ants")
    ]
    told = [picture.caption for picture in section.pictures]
    assert [caption.rpartition("Beside ")[2] for caption in told[:2]] == ["Fig. 15.", "Fig. 10."]
    assert "not found" in told[2]
    assert told[3].endswith("Beside Fig. 12.")
    assert section.note == "a note"
    files = drawn(section.pictures, tmp_path / "figures")
    for file in files:
        with Image.open(file) as image:
            assert image.width == 1600
    (again,) = sections([(AcoImproved(), first, FOUND, (CLAIM,)), (AcoLost(), lost_plan(), LOST, ())])
    for one, other in zip(files, drawn(again.pictures, tmp_path / "again"), strict=True):
        assert one.read_bytes() == other.read_bytes()
    for name in ("a.pdf", "b.pdf"):
        pdf_of([], tmp_path / name, "Plans", plans=[section])
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    assert len(re.findall(rb"/Type\s*/Page\b", (tmp_path / "a.pdf").read_bytes())) == 5


def test_a_planner_without_a_search_has_its_plan_alone(sections, tmp_path):
    plan = dataclasses.replace(made_up_plan(), polylines=(), history=None, smallest_radius=None)
    (section,) = sections([(Exact(20.0), plan, CORNERED, ())])
    assert [picture.stem for picture in section.pictures] == ["plans-1-nofly-1000x660-exact"]
    pdf_of([], tmp_path / "a.pdf", "Plans", plans=[section])


def test_no_path_at_all(sections, tmp_path):
    (section,) = sections([(AcoLost(), lost_plan(), LOST, ())])
    assert [picture.stem for picture in section.pictures] == [
        "plans-1-nofly-1000x660-aco-lost", "plans-1-nofly-1000x660-aco-lost-ants",
    ]  # fmt: skip
    pdf_of([], tmp_path / "a.pdf", "#panic()", plans=[dataclasses.replace(section, note="#panic() $x$ *b*")])


def test_a_planner_that_always_failed_has_a_row_and_no_picture(nofly, tmp_path):
    failed = PlanStatistics(seeds=2, found=0, missing={"failed": 2})
    (section,) = sections_of([by(nofly, Exact(), failed, seed=None)])
    assert section.pictures == []
    assert section.rows[0]["missing"] == "2 failed"
    pdf_of([], tmp_path / "a.pdf", "Plans", plans=[section])
