"""The smallest scale at which a plan is trackworthy."""

import json
import math
from typing import ClassVar

import msgspec
import numpy as np
import pytest

from campaigns.campaign import load_campaign
from campaigns.execute import execute
from campaigns.ready import make_ready
from campaigns.search_ready import make_searches_ready
from campaigns.search_steps import find
from planners.all_planners import ALL_PLANNERS
from planners.errors import InputError
from planners.map import Circle, Map, Raster
from planners.path import Path
from planners.planner import NO_PATH, Plan
from planners.scenario import Scenario, load_scenario, scaled
from small_campaigns import InThisProcess, write_campaign
from trackworthy.__main__ import main

# A bend of 90 degrees, whose radius is 10 map units
SCENARIO = 'name = "bend"\nsize = [60.0, 60.0]\nunit = 2.0\nstart = [10.0, 10.0]\ngoal = [40.0, 40.0]\n'
SEARCH = """
[[smallest_scale]]
name = "bend"
scenario = "bend.toml"
planner = "bend"
vehicle = "truck"
speed = 10
between = [0.5, 8.0]
"""
CALLS = []


class Bend(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An arc of `radius` [map units] between two straights; none below a unit of `least` [m]."""

    name: ClassVar[str] = "bend"
    summary: ClassVar[str] = "for tests"

    radius: float = 10.0
    least: float = 0.0
    fail: str = ""
    clearance: float = 0.0

    def plan(self, scenario, rng):
        CALLS.append(scenario.unit)
        if scenario.unit < self.least:
            if self.fail == "input":
                raise InputError(scenario.name, "its start has no room")
            if self.fail:
                raise ZeroDivisionError("a fault of ours")
            return Plan(outcome=NO_PATH, reason="the gate is too narrow")
        turn = np.linspace(0.0, math.pi / 2, 200)
        arc = np.column_stack([40.0 - self.radius * (1 - np.sin(turn)), 10.0 + self.radius * (1 - np.cos(turn))])
        points = np.vstack([[[10.0, 10.0]], arc, [[40.0, 40.0]]])
        return Plan(paths=(Path(points * scenario.unit),))


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("planners.all_planners.ALL_PLANNERS", (*ALL_PLANNERS, Bend))
    CALLS.clear()
    (tmp_path / "bend.toml").write_text(SCENARIO)


@pytest.fixture
def here(monkeypatch):
    """Searches in this process, where the planner for tests is."""
    monkeypatch.setattr("campaigns.execute.Machines.lanes", lambda machines, timeout: InThisProcess().lanes(timeout))


def ready(tmp_path, text):
    return make_searches_ready(load_campaign(str(write_campaign(tmp_path, text))))


def run(tmp_path, text, folder="out"):
    """What the searches found, by name."""
    campaign = load_campaign(str(write_campaign(tmp_path, text)))
    finished = execute(
        campaign, make_ready(campaign), tmp_path / folder, InThisProcess(), lambda one, *_: [*one],
        searches=make_searches_ready(campaign),
    )  # fmt: skip
    return {result.search.name: result for result in finished.searches}


# Scaled scenarios


@pytest.mark.parametrize("name", ["nofly-1000x660", "mars-hazards-15", "target-vehicle-71m"])
def test_a_scaled_scenario_is_that_of_the_same_file_with_another_unit(tmp_path, name):
    scenario = load_scenario(name)
    twice = scaled(scenario, 2.0 * scenario.unit)
    assert twice.unit == 2.0 * scenario.unit
    assert twice.size == (2.0 * scenario.size[0], 2.0 * scenario.size[1])
    assert np.array_equal(twice.starts, 2.0 * scenario.starts)
    assert np.array_equal(twice.goals, 2.0 * scenario.goals)
    for ring, other in zip(scenario.map.polygons, twice.map.polygons, strict=True):
        assert np.array_equal(other, 2.0 * ring)
    for one, other in zip(scenario.map.circles, twice.map.circles, strict=True):
        assert (other.x, other.y, other.radius) == (2.0 * one.x, 2.0 * one.y, 2.0 * one.radius)
    assert twice.map.bounds == tuple(2.0 * edge for edge in scenario.map.bounds)
    if scenario.map.raster is not None:
        assert twice.map.raster.cell == 2.0 * scenario.map.raster.cell
        assert np.array_equal(twice.map.raster.blocked, scenario.map.raster.blocked)
    assert (twice.max_range is None) == (scenario.max_range is None)
    assert twice.max_range is None or twice.max_range == 2.0 * scenario.max_range
    assert twice.max_turn_angle == scenario.max_turn_angle


def test_all_that_a_map_holds_is_scaled():
    ring = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]])
    area = Map(
        keep_in=(ring,), keep_in_circles=(Circle(1.0, 2.0, 3.0),), edge="open", raster=Raster(np.eye(2), 0.5, 1.0, 2.0)
    )
    end = np.array([[1.0, 1.0]])
    found = scaled(Scenario(name="one", map=area, starts=end, goals=end, size=(4.0, 4.0)), 3.0).map
    assert np.array_equal(found.keep_in[0], 3.0 * ring)
    assert found.keep_in_circles == (Circle(3.0, 6.0, 9.0),)
    assert (found.raster.cell, found.raster.x, found.raster.y) == (1.5, 3.0, 6.0)
    assert (found.bounds, found.edge) == (None, "open")


# Searches


def test_the_smallest_scale_is_where_the_bend_is_wide_enough(tmp_path):
    """A truck may take 0.6 g: at 10 m/s that is a radius of 100 / (0.6 * 9.80665) = 17 m, or 1.7 m a map unit.

    The vehicle's transient into an arc without an easement asks for a little more; twice would be too much.
    """
    (search,) = ready(tmp_path, SEARCH)
    found = find(search)
    assert found.error == ""
    assert 1.7 < found.at < 3.4
    assert found.failing.at < found.at <= 1.02 * found.failing.at
    assert not found.failing.trackworthy
    assert found.failing.metric in ("lateral_acceleration_max", "cross_track_max")
    tried = {step.at: step.trackworthy for step in found.steps}
    assert tried[found.at]
    assert list(tried) == CALLS  # planned anew at each scale
    again = find(ready(tmp_path, SEARCH + "tolerance = 0.5\n")[0])
    assert again.at / again.failing.at <= 1.5
    assert again.failing.at < found.at <= again.at * 1.02


@pytest.mark.parametrize(
    ("fail", "told"), [("", "no path: the gate is too narrow"), ("input", "its start has no room")]
)
def test_a_scale_without_a_path_is_not_trackworthy(tmp_path, fail, told):
    (search,) = ready(tmp_path, SEARCH + f'set = {{ least = 5.0, fail = "{fail}" }}\n')
    found = find(search)
    assert 5.0 <= found.at <= 5.0 * 1.02
    assert told in found.failing.reason


def test_ends_that_tell_all(tmp_path):
    (search,) = ready(tmp_path, SEARCH.replace("[0.5, 8.0]", "[0.5, 1.0]"))
    found = find(search)
    assert (found.at, found.failing.at, len(found.steps)) == (None, 1.0, 1)
    (search,) = ready(tmp_path, SEARCH.replace("[0.5, 8.0]", "[6.0, 8.0]"))
    found = find(search)
    assert (found.at, found.failing, len(found.steps)) == (6.0, None, 2)


def test_a_found_scale_is_kept_and_one_that_failed_is_tried_again(tmp_path):
    text = SEARCH + SEARCH.replace('"bend"\nscen', '"broken"\nscen') + 'set = { least = 5.0, fail = "crash" }\n'
    first = run(tmp_path, text)
    assert first["broken"].found.error == "ZeroDivisionError: a fault of ours"
    before, tries = (tmp_path / "out" / "summary.json").read_bytes(), len(CALLS)
    again = run(tmp_path, text)
    assert again["bend"].found == first["bend"].found
    assert CALLS[tries:] == [8.0, 0.5]  # those of the broken one
    assert (tmp_path / "out" / "summary.json").read_bytes() == before
    (kept,) = (tmp_path / "out" / "searches").iterdir()
    assert json.loads(kept.read_text())["at"] == first["bend"].found.at
    with pytest.raises(InputError, match="'smallest_scale bend' is not the same"):
        run(tmp_path, text.replace("speed = 10", "speed = 9"))


def test_lists_multiply_out_and_the_range_does_not(tmp_path):
    text = SEARCH.replace('planner = "bend"', 'planner = ["bend", "exact"]') + "set.clearance = [0.0, 1.0]\n"
    found = ready(tmp_path, text)
    assert [one.search.name for one in found] == [
        f"bend {planner} clearance {room}" for planner in ("bend", "exact") for room in ("0", "1")
    ]
    assert {one.search.between for one in found} == {(0.5, 8.0)}
    assert len({one.key for one in found}) == 4


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (("[0.5, 8.0]", "[8.0, 0.5]"), "'bend': between: 8 to 0.5 m is no range"),
        (("[0.5, 8.0]", "[0.0, 8.0]"), "smallest_scale[0]: between[0]: "),
        (('planner = "bend"', 'planner = "bond"'), "there is no planner 'bond'"),
        (("speed = 10", "trials = 3"), "unknown key 'trials'"),
        (("speed = 10", "conditions.latency = { uniform = [0, 1] }"), "conditions: each scale is flown once"),
        (("speed = 10", 'require = ["cross_trak<=1"]'), "there is no metric 'cross_trak'"),
    ],
)
def test_a_wrong_search_is_one_line_and_exit_code_2(tmp_path, change, told, capfd):
    assert main(["run", str(write_campaign(tmp_path, SEARCH.replace(*change)))]) == 2
    error = capfd.readouterr().err
    assert told in error
    assert len(error.strip().splitlines()) == 1


@pytest.mark.usefixtures("here")
def test_a_search_is_told_in_the_answer_the_summary_and_the_report(tmp_path, capfd):
    file = str(write_campaign(tmp_path, SEARCH))
    assert main(["run", file, "--dry-run"]) == 0
    assert "smallest scale of bend.toml, bend, truck, lqr, 0.5 to 8 m" in capfd.readouterr().out
    assert main(["run", file, "-o", "out"]) == 0
    told = json.loads((tmp_path / "out" / "summary.json").read_text())["smallest_scales"]
    assert [one["name"] for one in told] == ["bend"]
    unit = told[0]["smallest"]
    assert told[0]["map_size"] == [60.0 * unit, 60.0 * unit]
    assert (told[0]["passed"], told[0]["planner"], told[0]["failing"]["unit"] < unit) == (None, "bend", True)
    out = capfd.readouterr().out
    assert out.startswith("scale bend: smallest scale: ")
    assert " m a map unit (1" in out
    assert "; at " in out
    assert (tmp_path / "out" / "report.pdf").read_bytes().startswith(b"%PDF")
    before = (tmp_path / "out" / "summary.json").read_bytes()
    assert main(["run", "out/campaign.toml", "-o", "again"]) == 0
    assert (tmp_path / "again" / "summary.json").read_bytes() == before


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize(
    ("keys", "code", "told"),
    [
        ("expect_at_most = 4.0\n", 0, "pass  bend: smallest scale: "),
        ("expect_at_most = 1.0\n", 1, "FAIL  bend: smallest scale: "),
        ('set = { least = 9.0, fail = "crash" }\n', 3, "error bend: ZeroDivisionError: a fault of ours"),
        ("set.least = 9.0\n", 0, "scale bend: smallest scale: none up to 8 m a map unit; at 8 m: no path: the gate"),
    ],
)
def test_only_an_expectation_or_a_failure_decides_the_exit_code(tmp_path, keys, code, told, capfd, monkeypatch):
    monkeypatch.setattr("reports.write.write_report", lambda *_: [])
    assert main(["run", str(write_campaign(tmp_path, SEARCH + keys)), "-o", "out"]) == code
    assert capfd.readouterr().out.startswith(told)


def test_in_workers_too(tmp_path):
    """A straight line at any scale: of a planner that is there in workers."""
    text = SEARCH.replace('planner = "bend"', 'planner = "exact"')
    assert main(["run", str(write_campaign(tmp_path, text)), "-o", "out", "-j", "1"]) == 0
    (told,) = json.loads((tmp_path / "out" / "summary.json").read_text())["smallest_scales"]
    assert told["smallest"] == 0.5
    assert told["failing"] is None


def test_a_route_may_stay_the_same_at_every_scale(tmp_path):
    """Planned once, at the map's own 2 m a unit; below the planner's least scale it would find nothing."""
    anew = find(*ready(tmp_path, SEARCH + "set = { least = 1.9 }\n"))
    assert anew.at == pytest.approx(1.9, rel=0.02)
    CALLS.clear()
    same = find(*ready(tmp_path, SEARCH + "set = { least = 1.9 }\nreplan = false\n"))
    assert CALLS == [2.0]
    assert same == find(*ready(tmp_path, SEARCH))
