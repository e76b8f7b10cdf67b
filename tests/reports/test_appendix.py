import dataclasses

from campaigns.manifest import Manifest
from reports.pages.appendix import appendix_data
from reports.words.metric_definitions import METRIC_DEFINITIONS
from sample_results import result_of

MANIFEST = Manifest(
    name="n", store_version=1, schema_version=2, campaign="c" * 64, code="d" * 64,
    versions={"trackworthy": "0.1.0", "python": "3.11", "numpy": "2"}, git_revision="abc+", platform="Linux", seed=7,
    cases={"delivery-route": "e" * 64}, called="my campaign.toml",
)  # fmt: skip


def test_every_metric_that_is_measured_has_a_definition(route, yard, fleet):
    for outcome in (route, yard, fleet):
        assert set(outcome.metrics) <= set(METRIC_DEFINITIONS)
    told = appendix_data([result_of(route, trials=1, bad=0)], {}, None)["metrics"]
    assert [row["name"] for row in told] == [name for name in METRIC_DEFINITIONS if name in route.metrics]


def test_what_made_the_results():
    made = dict(appendix_data([], {}, MANIFEST)["made"])
    assert made["command"] == "trackworthy run 'my campaign.toml'"
    assert made["git revision"] == "abc with changes"
    assert (made["seed of the campaign"], made["libraries"], made["trackworthy"]) == ("7", "numpy 2", "0.1.0")
    assert made["hash of the code"] == "d" * 64


def test_a_requirement_is_told_once_with_its_source_and_its_cases(route):
    other = dataclasses.replace(route, name="other")
    results = [result_of(route, trials=1, bad=0), result_of(other, trials=1, bad=0, number=2)]
    told = appendix_data(results, {route.name: route, "other": other}, MANIFEST)["requirements"]
    limits = [limit["name"] for group in told for limit in group["limits"]]
    assert sorted(limits) == sorted(margin.requirement.metric for margin in route.verdict.margins)
    assert {group["cases"] for group in told} == {"all 2 cases"}
    assert {group["source"] for group in told} == {margin.requirement.source for margin in route.verdict.margins}


def test_seeds_of_every_case(route):
    (row,) = appendix_data([result_of(route, trials=8)], {"route": route}, MANIFEST)["seeds"]
    assert (row["trials"], row["seeds"], row["worst"], row["hash"]) == ("8", "1 … 8", "8: 8", "e" * 12)
