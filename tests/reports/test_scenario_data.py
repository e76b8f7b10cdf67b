import dataclasses

from reports.figures.scenario_cases import scenario_runs
from reports.pages.scenario_data import scenarios_data
from sample_results import result_of, unplanned


def told_of(results, outcomes, plans=None):
    return scenarios_data(scenario_runs(results, outcomes), plans or {})


def test_cases_go_under_their_map_or_their_path(route, yard):
    results = [
        result_of(route, trials=1, bad=0, path="folder/a.plan"),
        unplanned(scenario="mars-gap"),
        result_of(yard, trials=1, bad=0, number=3, path="folder/a.plan"),
    ]
    told = told_of(results, {route.name: route, yard.name: yard}, {"lost": {"rows": []}})
    assert [one["name"] for one in told] == ["a.plan", "mars-gap"]
    assert [one["cases"] for one in told] == [[route.name, yard.name], ["lost"]]
    assert [one["plans"] for one in told] == [None, {"rows": []}]


def test_what_is_missed_the_worst_first_with_the_share_of_trials(route):
    result = result_of(route, trials=8, bad=3, path="a.plan")
    (told,) = told_of([result], {route.name: route})
    missed = [margin for margin in route.verdict.margins if not margin.met]
    assert len(told["violations"]) == told["violations_count"] == len(missed) > 0
    row = next(row for row in told["violations"] if row["words"] == "cross-track error, max")
    assert row["trials"] == "3 of 8"
    assert row["by"] in f"{route.verdict.decisive.value}" or row["by"].endswith("m")


def test_what_could_not_be_tried_is_told(route):
    (told,) = told_of([result_of(route, trials=4, bad=0, errors=3, path="a.plan")], {})
    assert told["violations"][0]["words"] == "failed to run"
    assert told["violations"][0]["trials"] == "3 of 4"
    (told,) = told_of([unplanned(trials=2)], {})
    assert (told["violations"][0]["words"], told["violations"][0]["note"]) == ("no path", "none of 9 ants arrived")


def test_no_more_than_a_page_of_them(route):
    outcomes = {f"c{i}": dataclasses.replace(route, name=f"c{i}") for i in range(40)}
    results = [result_of(one, trials=1, bad=1, number=i, path="a.plan") for i, one in enumerate(outcomes.values())]
    (told,) = told_of(results, outcomes)
    assert len(told["violations"]) == 14
    assert told["violations_count"] >= 40
