"""The gate against planted faults, and against none."""

import dataclasses
import json
import shlex

import msgspec
import numpy as np
import pytest

from campaigns.baseline import read_baseline, read_record, write_baseline
from campaigns.gate import APPEARED, ERRORS, UNMEASURED, VANISHED, VERDICT, WORSE, check
from planners import files
from planners.errors import InputError
from planners.path import Path
from sample_paths import road_weave
from sim import jsbsim_model
from sim.wind import Wind
from small_campaigns import AIR, ROAD, run_here, write_campaign
from tracking.controllers.lqr import Lqr
from tracking.sensors import Sensors

SPREAD = """
[[case]]
name = "spread"
path = "road.csv"
vehicle = "truck"
speed = "40km/h"
trials = 20
[case.conditions]
cross_track_offset = { uniform = [0, 0.2] }
position_noise = { uniform = [0, 0.05] }
latency = { uniform = [0, 0.1] }
friction = { weibull = [8, 0.8] }
"""


def record(folder, cases, name="out", head="seed = 1"):
    run_here(write_campaign(folder, cases, head=head), folder / name, fresh=True)
    return read_record(folder / name)


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    """The record of a truck and an aircraft, 20 trials each."""
    return record(tmp_path_factory.mktemp("good"), ROAD + AIR)


@pytest.fixture(scope="module")
def baseline(good):
    return good.baseline


def worse(found):
    return {(f.comparison.case, f.comparison.metric) for f in found.findings if f.kind == WORSE}


def test_nothing_is_found_in_the_same_results(good, baseline):
    found = check(good, baseline)
    assert found.findings == ()
    assert found.improved == ()
    assert {one.case for one in found.comparisons} == {"road", "air"}


@pytest.mark.parametrize(("case", "block", "factor"), [("road", ROAD, 0.86), ("air", AIR, 0.90)])
def test_a_gain_that_worsens_p95_by_a_tenth_is_caught(tmp_path, baseline, monkeypatch, case, block, factor):
    solve = Lqr.reset

    def weaker(self, limits, dt):
        solve(self, limits, dt)
        self._k_e *= factor

    monkeypatch.setattr(Lqr, "reset", weaker)
    found = check(record(tmp_path, block), baseline)
    (p95,) = (one for one in found.comparisons if one.metric == "cross_track_p95")
    assert p95.new / p95.old == pytest.approx(1.10, abs=0.015)
    assert (case, "cross_track_p95") in worse(found)


def test_a_sensor_delayed_by_a_fifth_of_a_second_is_caught(tmp_path, baseline, monkeypatch):
    def late(**settings):
        return Sensors(**{**settings, "latency": settings["latency"] + 0.2})

    monkeypatch.setattr("campaigns.conditions.Sensors", late)
    found = worse(check(record(tmp_path, ROAD + AIR), baseline))
    assert {("road", "cross_track_p95"), ("road", "heading_error_rms"), ("air", "course_error_rms")} <= found


def test_a_crab_angle_to_the_wrong_side_is_caught(tmp_path, baseline, monkeypatch):
    right = jsbsim_model.heading_for_course

    def wrong(airspeed, course, wind):
        return right(airspeed, course, Wind(-wind.east, -wind.north))

    monkeypatch.setattr(jsbsim_model, "heading_for_course", wrong)
    found = worse(check(record(tmp_path, ROAD + AIR), baseline))
    assert ("air", "cross_track_p95") in found
    assert all(case == "air" for case, _ in found)


def test_wind_from_the_wrong_side_is_caught(tmp_path, monkeypatch):
    """A path to the east in wind from the east: from the west it is a tailwind, and every turn needs more room."""
    headwind = AIR.replace("[200, 280]", "[60, 120]").replace("trials = 20", "trials = 8")
    before = record(tmp_path, headwind).baseline
    own = Wind.blowing_from
    monkeypatch.setattr(Wind, "blowing_from", staticmethod(lambda speed, deg: own(speed, deg + 180.0)))
    assert ("air", "turn_radius_required") in worse(check(record(tmp_path, headwind), before))


def test_fifty_runs_of_the_same_code_raise_no_alarm(tmp_path):
    road = road_weave(12.5).resample(4.0)
    files.write(Path(road.points[road.s <= 60.0]), tmp_path / "short.csv")
    few = ROAD.replace("trials = 20", "trials = 5").replace("road.csv", "short.csv")
    before = record(tmp_path, few).baseline
    for _ in range(50):
        found = check(record(tmp_path, few), before)
        assert found.findings == ()
        assert all(one.old == pytest.approx(one.new, rel=1e-5) for one in found.comparisons)


@pytest.mark.parametrize("seed", range(2, 8))
def test_another_seed_raises_no_alarm(tmp_path_factory, seed):
    folder = tmp_path_factory.getbasetemp() / "seeds"
    before = _first_seed(folder)
    found = check(record(folder, ROAD + SPREAD, head=f"seed = {seed}"), before)
    assert found.findings == ()
    assert not set(before.cases["road"].seeds) & set(read_record(folder / "out").baseline.cases["road"].seeds)


def _first_seed(folder):
    file = folder / "first.json"
    if not file.exists():
        write_baseline(record(folder, ROAD + SPREAD).baseline, file)
    return read_baseline(file)


def changed(record, **cases):
    """`record` with some of its cases' baselines replaced."""
    new = msgspec.structs.replace(record.baseline, cases={**record.baseline.cases, **cases})
    return dataclasses.replace(record, baseline=new)


def scaled(case, metric, factor):
    values = [None if value is None else factor * value for value in case.metrics[metric]]
    return msgspec.structs.replace(case, metrics={**case.metrics, metric: values})


@pytest.mark.parametrize(("factor", "found"), [(1.04, False), (1.06, True), (0.5, False)])
def test_the_relative_limit_is_what_it_says(good, baseline, factor, found):
    air = baseline.cases["air"]
    worsened = changed(good, air=scaled(air, "cross_track_p95", factor))
    assert (("air", "cross_track_p95") in worse(check(worsened, baseline))) == found


def test_where_higher_is_better_less_is_worse(good, baseline):
    air = baseline.cases["air"]
    assert ("air", "stall_margin_min") in worse(
        check(changed(good, air=scaled(air, "stall_margin_min", 0.8)), baseline)
    )
    better = check(changed(good, air=scaled(air, "stall_margin_min", 1.2)), baseline)
    assert worse(better) == set()
    assert [one.metric for one in better.improved] == ["stall_margin_min"]


def test_the_campaigns_own_limit_replaces_the_default(good, baseline):
    from campaigns.limits import Limit

    air = scaled(baseline.cases["air"], "cross_track_p95", 1.2)
    wide = dataclasses.replace(good.campaign, check={"cross_track_p95": Limit(relative=0.3)})
    assert worse(check(dataclasses.replace(changed(good, air=air), campaign=wide), baseline)) == set()


def test_one_bad_trial_among_twenty_is_no_regression_of_the_mean_by_chance(good, baseline):
    """The interval of the mean includes zero: 19 differences of nothing and one of much."""
    air = baseline.cases["air"]
    values = list(air.metrics["cross_track_p95"])
    values[3] *= 10.0
    one_bad = msgspec.structs.replace(air, metrics={**air.metrics, "cross_track_p95": values})
    assert worse(check(changed(good, air=one_bad), baseline)) == set()


def test_the_worst_seed_is_named_with_its_command(good, baseline):
    air = baseline.cases["air"]
    values = [1.2 * value for value in air.metrics["cross_track_p95"]]
    values[7] *= 1.5
    worsened = msgspec.structs.replace(air, metrics={**air.metrics, "cross_track_p95": values})
    (finding,) = check(changed(good, air=worsened), baseline).findings
    assert (finding.trial, finding.seed) == (8, air.seeds[7])
    words = shlex.split(finding.command)
    assert words[:2] == ["trackworthy", "run"]
    assert words[3:] == ["--case", "air", "--trial", "8"]


def test_cases_that_vanish_appear_flip_or_fail(good, baseline):
    road = baseline.cases["road"]
    others = {"air": baseline.cases["air"]}
    gone = msgspec.structs.replace(baseline, cases={"road": road, "old": road})
    assert {f.kind: f.case for f in check(good, gone).findings} == {VANISHED: "old", APPEARED: "air"}
    flipped = msgspec.structs.replace(road, verdict="not-trackworthy")
    (finding,) = check(good, msgspec.structs.replace(baseline, cases={**others, "road": flipped})).findings
    assert finding.kind == VERDICT
    assert finding.command
    failed = check(changed(good, road=msgspec.structs.replace(road, errors=2)), baseline)
    assert [f.kind for f in failed.findings] == [ERRORS]
    assert failed.machinery_failed
    metrics = {name: values for name, values in road.metrics.items() if name != "clearance_min"}
    old = msgspec.structs.replace(road, metrics={**metrics, "bank_max": [1.0] * 20})
    (finding,) = check(good, msgspec.structs.replace(baseline, cases={**others, "road": old})).findings
    assert finding.kind == UNMEASURED


def test_baselines_are_small_and_come_back(good, baseline, tmp_path):
    file = tmp_path / "baseline.json"
    write_baseline(baseline, file)
    assert read_baseline(file) == baseline
    text = file.read_text()
    assert len(text) < 20_000
    assert json.loads(text)["schema"] == 1
    assert max(map(len, text.splitlines())) < 1200
    values = np.array(baseline.cases["air"].metrics["bank_max"])
    raw = good.results[1].statistics
    assert values == pytest.approx(np.degrees(raw.values[:, raw.names.index("bank_max")]), rel=1e-5)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("{", "is not a baseline"),
        ('{"baseline": 1}', "is not a baseline"),
        ('{"baseline": 0, "schema": 1, "campaign": "x", "units": {}, "cases": {}}', "is of version 0, schema 1"),
        ('{"baseline": 1, "schema": 99, "campaign": "x", "units": {}, "cases": {}}', "schema 99"),
        (
            '{"baseline": 1, "schema": 1, "campaign": "x", "units": {}, "cases": {"a": {"verdict": "trackworthy", '
            '"trackworthy": 1, "trials": 1, "errors": 0, "seeds": [1], "numbers": [1], "metrics": {"bank_max": []}}}}',
            "not as many values as seeds",
        ),
    ],
)
def test_a_baseline_that_is_none_is_one_line(tmp_path, text, told):
    file = tmp_path / "b.json"
    file.write_text(text)
    with pytest.raises(InputError, match="--update") as error:
        read_baseline(file)
    assert told in str(error.value)


def test_an_unfinished_run_is_not_checked(tmp_path):
    few = ROAD.replace("trials = 20", "trials = 2")
    run_here(write_campaign(tmp_path, few), tmp_path / "out")
    resolved = tmp_path / "out" / "campaign.toml"
    resolved.write_text(resolved.read_text().replace("trials = 2", "trials = 3"))
    with pytest.raises(InputError, match="2 of 3 trials of 'road' are done; run the campaign to its end first"):
        read_record(tmp_path / "out")


def test_a_folder_without_results_is_one_line(tmp_path):
    with pytest.raises(InputError, match="holds no results; run a campaign first"):
        read_record(tmp_path)


def renumbered(case, **changes):
    """The same case as if it had been run with other seeds."""
    return msgspec.structs.replace(case, seeds=[seed + 1 for seed in case.seeds], **changes)


@pytest.mark.parametrize(("trackworthy", "told"), [(19, False), (16, False), (10, True), (0, True)])
def test_with_other_seeds_a_verdict_flips_by_more_than_chance(good, baseline, trackworthy, told):
    """Fisher's exact test, two cases: 20 of 20 against 16 of 20 is p = 0.106, against 10 of 20 p = 0.0004."""
    road = renumbered(baseline.cases["road"], verdict="not-trackworthy", trackworthy=trackworthy)
    kinds = [finding.kind for finding in check(changed(good, road=road), baseline).findings]
    assert kinds == ([VERDICT] if told else [])


def test_with_the_same_seeds_every_flip_counts(good, baseline):
    road = msgspec.structs.replace(baseline.cases["road"], verdict="not-trackworthy", trackworthy=19)
    assert [finding.kind for finding in check(changed(good, road=road), baseline).findings] == [VERDICT]
