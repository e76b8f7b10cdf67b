import json
from dataclasses import asdict, replace

import pytest

from campaigns.comparison import Comparison
from campaigns.gate import ERRORS, WORSE, Check, Finding
from reports.files.check_json import check_json

P95 = Comparison(
    case="road", metric="cross_track_p95", unit="m", old=0.1 + 0.2, new=1 / 3, worse=1e-300, limit=5e-324,
    regressed=True, improved=False, trial=7, seed=2**53 - 1,
)  # fmt: skip
BETTER = replace(P95, metric="bank_max", unit="deg", worse=-12345678.9, regressed=False, improved=True)
COMMAND = "trackworthy run out/campaign.toml --case road --trial 7"
NASTY = [
    "a|b",
    "`ls`",
    "line\nbreak\r\n",
    "<script>",
    "50 %",
    "a: b, c",
    "🚚",
    'say "hi"',
    "\x00\x1b[31m\x7f\u2028\ud7ff",
]


def refuse(constant):
    raise AssertionError(f"{constant} is no JSON")


def parsed(check):
    return json.loads(check_json(check), parse_constant=refuse)


def worse(one):
    return Finding(WORSE, one.case, f"{one.metric} is worse", one, one.trial, one.seed, COMMAND)


def test_a_worse_metric_has_all_its_numbers_to_the_last_digit():
    (found,) = parsed(Check("nightly", (P95,), (worse(P95),), ()))["findings"]
    assert found.pop("message").startswith("cross_track_p95 was 0.3 m, is 0.3333 m: worse by ")
    assert found == {
        "kind": "worse", "case": "road", "trial": 7, "seed": 2**53 - 1, "command": COMMAND, "metric": "cross_track_p95",
        "unit": "m", "old": P95.old, "new": P95.new, "worse": P95.worse, "limit": P95.limit,
    }  # fmt: skip


def test_a_finding_about_a_case_has_the_same_keys():
    check = Check("nightly", (P95,), (worse(P95), Finding(ERRORS, "air", "2 of 5 trials failed to run")), ())
    of_metric, of_case = parsed(check)["findings"]
    assert of_case.keys() == of_metric.keys()
    assert {key for key, value in of_case.items() if value is None} == {
        "trial", "seed", "metric", "unit", "old", "new", "worse", "limit",
    }  # fmt: skip
    assert (of_case["kind"], of_case["message"]) == ("errors", "2 of 5 trials failed to run")


def test_every_comparison_is_there_whether_found_or_not():
    check = Check("nightly", (P95, BETTER), (worse(P95),), (BETTER,))
    assert parsed(check)["comparisons"] == [asdict(P95), asdict(BETTER)]


def test_passed_says_whether_anything_was_found():
    assert parsed(Check("nightly", (P95, BETTER), (), (BETTER,)))["passed"] is True
    assert parsed(Check("nightly", (P95,), (worse(P95),), ()))["passed"] is False
    assert parsed(Check("nightly", (), (), ())) == {
        "campaign": "nightly", "passed": True, "findings": [], "comparisons": [],
    }  # fmt: skip


@pytest.mark.parametrize("name", NASTY)
def test_any_name_comes_back(name):
    one = replace(P95, case=name)
    found = parsed(Check(name, (one,), (worse(one), Finding(ERRORS, name, name)), ()))
    assert found["campaign"] == name
    assert [finding["case"] for finding in found["findings"]] == [name, name]
    assert found["findings"][1]["message"] == name
    assert found["comparisons"][0]["case"] == name
