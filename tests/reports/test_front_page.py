import dataclasses
import re

import pytest

from campaigns.search import SpeedSearch
from campaigns.search_steps import Found
from campaigns.searches import SearchResult
from reports.pages.front_page import case_words, front_data
from reports.pages.pdf import write_pdf
from reports.pages.report_data import Report, report_of
from sample_results import result_of, unplanned
from sim.planet import planet_of


def named(outcome, name):
    return dataclasses.replace(outcome, name=name)


def front(*pairs, searches=(), campaign="a.toml"):
    """The page of (result, outcome) pairs."""
    results = [result for result, _ in pairs]
    outcomes = {outcome.name: outcome for _, outcome in pairs if outcome is not None}
    return front_data(results, outcomes, searches, campaign, f"trackworthy run {campaign}")


def search(name, at, **expected):
    kept = SpeedSearch(name=name, path="road.csv", vehicle="truck", between=(5.0, 25.0), **expected)
    return SearchResult(kept, None, "ground", Found(at=at))


def test_the_answer_counts_what_is_as_expected_or_what_is_not(route, yard):
    good = (result_of(named(yard, "good"), trials=1, bad=0), named(yard, "good"))
    bad = (result_of(route, trials=1, bad=1, number=2), route)
    assert front(good)["headline"] == {"number": "1 of 1", "words": "case came out as expected"}
    assert front(good)["counts"] == "1 trackworthy, 0 not trackworthy; 1 trial in all"
    told = front(good, bad)
    assert told["headline"] == {"number": "1 of 2", "words": "cases did not come out as expected"}
    assert not told["good"]
    assert told["repeat"] == "trackworthy run a.toml"


def test_only_searches_are_an_answer_too():
    asked = [search("slow", 12.0, expect_at_least=8.0), search("fast", 12.0, expect_at_least=22.0)]
    told = front(searches=asked)
    assert told["headline"] == {"number": "1 of 2", "words": "searches did not come out as expected"}
    assert told["worst"][0]["title"] == "Searches that are not as expected"
    assert told["tested"] == [["searches", "2 for the top speed: road.csv with truck under lqr"]]
    assert front(searches=[search("free", 12.0)])["headline"] == {"number": "1", "words": "search made"}


def test_what_is_not_as_expected_comes_first(route, yard):
    near, worst = named(yard, "near"), route
    told = front((result_of(near, trials=1, bad=0), near), (result_of(worst, trials=1, bad=1, number=2), worst))
    assert [group["title"] for group in told["worst"]] == ["Not as expected", "Trackworthy, and nearest to a limit"]
    assert told["worst"][0]["rows"][0]["case"] == worst.name
    expected = result_of(worst, trials=1, bad=1, expect="not-trackworthy")
    assert [group["title"] for group in front((expected, worst))["worst"]] == ["Not trackworthy, as expected"]


def test_no_more_than_five_are_told(route):
    pairs = [(result_of(named(route, f"c{i}"), trials=1, bad=1, number=i), named(route, f"c{i}")) for i in range(60)]
    (group,) = front(*pairs)["worst"]
    assert (len(group["rows"]), group["more"]) == (5, 55)


def test_trials_that_failed_and_paths_that_were_not_found(route):
    assert case_words(result_of(route, trials=4, bad=0, errors=3), route) == "3 of 4 trials failed to run: it fell over"
    assert case_words(unplanned(), None) == ("has no path to follow: the planner found none (none of 9 ants arrived)")
    told = case_words(result_of(route, trials=8, bad=1, pass_share=0.9), route)
    assert told.startswith("7 of 8 trials are trackworthy, where 90 % are asked; the worst ")


def test_what_was_tested(route, yard):
    fast = named(yard, "fast")
    told = dict(
        front((result_of(yard, trials=4, path="yard.csv"), yard), (result_of(fast, trials=1, path="b.csv"), fast))[
            "tested"
        ]
    )
    assert told["paths"] == "yard.csv, b.csv"
    assert told["vehicle"].startswith(f"{yard.vehicle} at ")
    assert told["trials"] == "2 cases of 1 to 4 trials each"
    assert "conditions" not in told  # no wind moves a truck


def test_a_planet_that_is_not_earth_is_named(route):
    away = dataclasses.replace(route, limits=dataclasses.replace(route.limits, gravity=planet_of("mars").gravity))
    assert dict(front((result_of(away, trials=1), away))["tested"])["planet"] == f"{route.vehicle} on Mars"
    assert "planet" not in dict(front((result_of(route, trials=1), route))["tested"])


NAMES = ["x" * 120, '#panic() $x$ *b* [a] @ref <label> <script>alert(1)</script> "', "a/b_c-d=e " * 12]


@pytest.mark.parametrize("paper", ["a4", "us-letter"])
@pytest.mark.parametrize("count", [1, 60])
def test_the_first_page_is_one_page(route, tmp_path, count, paper):
    """However many cases, however long their names: with all else left out there is but that page."""
    outcomes = {f"{NAMES[i % 3]} {i}": named(route, f"{NAMES[i % 3]} {i}") for i in range(count)}
    results = [result_of(one, trials=1, bad=i % 2, number=i) for i, one in enumerate(outcomes.values())]
    told = front_data(results, outcomes, [], NAMES[0])
    data = report_of([], NAMES[0]).data | {"front": told}
    write_pdf(Report(data, [], []), tmp_path, tmp_path / "a.pdf", paper)
    assert len(re.findall(rb"/Type\s*/Page\b", (tmp_path / "a.pdf").read_bytes())) == 1


def test_a_case_that_is_not_shown_whole_says_what_decides_it(yard):
    assert case_words(result_of(yard, trials=1, bad=1), None).startswith(
        "is not trackworthy, decided by cross-track error: margin −"
    )
