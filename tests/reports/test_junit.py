import xml.etree.ElementTree as ET
from dataclasses import replace

import pytest

from campaigns.comparison import Comparison
from campaigns.gate import APPEARED, ERRORS, UNMEASURED, VERDICT, WORSE, Check, Finding
from reports.files.junit import check_junit

P95 = Comparison(
    case="road", metric="cross_track_p95", unit="m", old=0.1, new=0.2, worse=0.1, limit=0.005,
    regressed=True, improved=False, trial=7, seed=9,
)  # fmt: skip
FINE = replace(P95, metric="cross_track_rms", new=0.1, worse=0.0, regressed=False)
COMMAND = "trackworthy run out/campaign.toml --case road --trial 7"
NASTY = ["a|b", "`ls`", "line\nbreak", "<script>&amp;]]>", "50 %", "a: b, c", "🚚", "'\"", "tab\t."]


def worse(one, command=COMMAND):
    return Finding(WORSE, one.case, f"{one.metric} is worse", one, one.trial, one.seed, command)


def suite_of(check):
    suites = ET.fromstring(check_junit(check).encode())
    (suite,) = suites
    assert (suites.tag, suite.tag) == ("testsuites", "testsuite")
    return suite


def of_each(suite):
    """(case, test) -> tags of what is in it."""
    return {(test.get("classname"), test.get("name")): [child.tag for child in test] for test in suite}


def test_a_violated_limit_is_a_failure_and_an_error_an_error():
    findings = (
        worse(P95), Finding(ERRORS, "air", "2 of 5 trials failed to run"), Finding(APPEARED, "new", "not there"),
        Finding(VERDICT, "bend", "was trackworthy, is not-trackworthy", None, 3, 4, "again"),
    )  # fmt: skip
    suite = suite_of(Check("nightly", (P95, FINE), findings, ()))
    assert of_each(suite) == {
        ("road", "cross_track_p95"): ["failure"],
        ("road", "cross_track_rms"): [],
        ("air", "errors"): ["error"],
        ("new", "appeared"): ["failure"],
        ("bend", "verdict"): ["failure"],
    }
    assert {key: suite.get(key) for key in ("tests", "failures", "errors")} == {
        "tests": "5", "failures": "3", "errors": "1",
    }  # fmt: skip
    assert suite.get("name") == "trackworthy check nightly"


def test_without_findings_every_test_passes():
    suite = suite_of(Check("nightly", (P95, FINE), (), (P95,)))
    assert [len(test) for test in suite] == [0, 0]
    assert (suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("2", "0", "0")


def test_a_failure_has_the_numbers_and_the_command():
    suite = suite_of(Check("nightly", (P95,), (worse(P95),), ()))
    (failure,) = suite.iter("failure")
    assert failure.get("type") == "worse"
    assert failure.get("message") == "cross_track_p95 was 0.1 m, is 0.2 m: worse by 0.1 m, allowed 0.005 m"
    assert failure.text.splitlines() == [failure.get("message"), COMMAND]


def test_the_same_metric_of_another_case_does_not_fail():
    air = replace(P95, case="air", regressed=False)
    suite = suite_of(Check("nightly", (air, P95), (worse(P95),), ()))
    assert of_each(suite) == {("air", "cross_track_p95"): [], ("road", "cross_track_p95"): ["failure"]}


@pytest.mark.parametrize("name", NASTY)
def test_any_name_comes_back(name):
    one = replace(P95, case=name)
    findings = (worse(one, f"run --case {name}"), Finding(ERRORS, name, name))
    suite = suite_of(Check(name, (one,), findings, ()))
    assert suite.get("name") == f"trackworthy check {name}"
    assert [test.get("classname") for test in suite] == [name, name]
    (failure,), (error,) = suite.iter("failure"), suite.iter("error")
    assert failure.text.endswith(f"run --case {name}")
    assert error.get("message") == name


NOT_IN_XML = "a\x00\x08\x1b[31m\x7f\ufffe\uffff"


def test_what_xml_cannot_hold_is_replaced():
    one = replace(P95, case=NOT_IN_XML)
    suite = suite_of(Check(NOT_IN_XML, (one,), (worse(one), Finding(ERRORS, NOT_IN_XML, NOT_IN_XML)), ()))
    assert {test.get("classname") for test in suite} == {"a???[31m???"}
    assert [error.text for error in suite.iter("error")] == ["a???[31m???"]


def test_what_xml_cannot_hold_is_replaced_in_a_command():
    suite = suite_of(Check("nightly", (P95,), (worse(P95, f"run {NOT_IN_XML}"),), ()))
    (failure,) = suite.iter("failure")
    assert failure.text.splitlines()[1] == "run a???[31m???"


def test_tests_of_a_case_have_different_names():
    findings = tuple(
        Finding(UNMEASURED, "road", f"{metric} cannot be measured any more") for metric in ("bank_max", "frechet")
    )
    assert len(of_each(suite_of(Check("nightly", (P95,), findings, ())))) == 3
