import dataclasses

from campaigns.campaign import replay_command
from campaigns.finished import SHOWN
from campaigns.seeds import plan_seed
from reports.html.absent import absent
from reports.html.case_rows import case_rows
from sample_results import result_of, unplanned
from tracking.metric import Metric, Requirement
from tracking.verdict import EITHER, judge


def judged_by(outcome, name, metric, requirement):
    return dataclasses.replace(outcome, name=name, verdict=judge({metric.name: metric}, (requirement,), EITHER))


def test_margins_are_ranked_by_share_and_lost_cases_come_first(finished, route):
    near, far = (
        judged_by(
            route, name, Metric("cross_track_max", value, "m", "lower"), Requirement("cross_track_max", "<=", 30.0)
        )
        for name, value in (("near", 29.0), ("far", 90.0))
    )
    touching = judged_by(  # at a corridor of 30 m it misses by less than three times the limit does
        route, "touching", Metric("clearance_min", -31.0, "m", "higher"), Requirement("clearance_min", ">=", 0.0)
    )
    outcomes = {one.name: one for one in (near, far, touching)}
    results = [result_of(one, number=i, trials=1, bad=0) for i, one in enumerate(outcomes.values(), start=1)]
    results += [
        dataclasses.replace(unplanned(), number=4),
        dataclasses.replace(result_of(near, trials=1, bad=0, errors=1), number=5),
    ]
    rows = case_rows(dataclasses.replace(finished, results=results, outcomes=outcomes))
    ranked = [row["number"] for row in sorted(rows, key=lambda row: row["rank"])]
    assert route.corridor == 30.0
    assert ranked == [5, 4, 2, 3, 1]
    words = {row["number"]: (row["margin_words"], row["margin_share"]) for row in rows}
    assert words[4] == ("no path", "")
    assert words[5] == ("failed to run", "")
    assert words[3] == ("−31 m", "−103 % of corridor")


def test_what_cannot_be_replayed_says_why(finished):
    lost = unplanned(trials=3, replan=True)
    told = absent(dataclasses.replace(finished, results=[lost, *finished.results[1:]]))
    assert list(told) == ["lost"]
    assert "no path in any of 3 trials: none of 9 ants arrived" in told["lost"]["why"]
    assert told["lost"]["seed"] == str(plan_seed(finished.campaign.seed, lost.case, 1))
    assert told["lost"]["command"] == replay_command(finished.called, "lost", 1)


def test_cases_beyond_those_shown_whole_say_so(finished, route):
    results = [
        result_of(dataclasses.replace(route, name=f"case {i}"), number=i, trials=1, bad=0) for i in range(SHOWN + 1)
    ]
    told = absent(dataclasses.replace(finished, results=results, outcomes={}))
    assert f"of {SHOWN + 1} cases the report shows {SHOWN} whole" in told[f"case {SHOWN}"]["why"]
    assert "its track was not kept" in told["case 0"]["why"]
