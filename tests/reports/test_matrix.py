import dataclasses

import msgspec

from reports.pages.matrix import matrix_data
from reports.pages.shades import shade
from reports.words.deciding import deciding
from reports.words.dimensions import dimensions
from sample_results import result_of, unplanned
from tracking.metric import Metric, Requirement
from tracking.verdict import EITHER, judge


def cases(yard, *settings):
    """Cases like `yard`, one for each of the `settings`; with their outcomes."""
    outcomes = [dataclasses.replace(yard, name=f"case {i}") for i in range(len(settings))]
    results = [
        result_of(outcome, number=i, **({"trials": 1, "bad": 0, "path": "a.csv"} | setting))
        for i, (outcome, setting) in enumerate(zip(outcomes, settings, strict=True), start=1)
    ]
    return results, {outcome.name: outcome for outcome in outcomes}


def test_what_varies_stands_at_rows_and_columns(yard):
    results, outcomes = cases(
        yard,
        *({"path": path, "controller": controller} for path in ("a.csv", "b.csv") for controller in ("lqr", "stanley")),
    )
    told = matrix_data(results, outcomes)
    assert (told["down"], told["across"]) == (["path"], ["controller"])
    assert told["rows"] == [["a.csv"], ["b.csv"]]
    assert told["columns"] == [["lqr"], ["stanley"]]
    assert [[cell["case"] for cell in row] for row in told["cells"]] == [["case 0", "case 1"], ["case 2", "case 3"]]
    assert told["same"][0] == f"vehicle {yard.vehicle}"
    assert told["same"][1].startswith("speed ")


def test_columns_of_a_vehicle_stand_together(yard):
    results, outcomes = cases(yard, *({"controller": name} for name in ("lqr", "stanley", "lqr")))
    told = matrix_data(results, outcomes)
    assert told["columns"] == [["lqr"], ["stanley"]]
    assert [cell["count"] for cell in told["cells"][0]] == [2, 1]


def test_a_cell_shows_the_worst_of_its_cases(yard):
    results, outcomes = cases(yard, {}, {"bad": 1}, {})
    del outcomes["case 1"]
    ((cell,),) = matrix_data(results, outcomes)["cells"]
    assert (cell["case"], cell["count"], cell["met"], cell["passed"]) == ("case 1", 3, False, False)


def test_a_case_that_is_not_there_leaves_a_hole(yard):
    results, outcomes = cases(yard, {"path": "a.csv"}, {"path": "b.csv", "controller": "l1"})
    assert [[cell and cell["case"] for cell in row] for row in matrix_data(results, outcomes)["cells"]] == [
        ["case 0", None], [None, "case 1"],
    ]  # fmt: skip


def test_margins_are_shares_of_their_limit_or_as_they_are(yard, route):
    margin = route.verdict.decisive
    found = deciding(result_of(route, trials=1, bad=1), route)
    assert found.share == margin.relative
    assert found.words == "<−1000 %" or found.words.endswith(" %")
    clear = Metric("clearance_min", 0.2, "m", "higher")
    verdict = judge({"clearance_min": clear}, (Requirement("clearance_min", ">=", 0.0),), EITHER)
    only = dataclasses.replace(yard, verdict=verdict)
    told = deciding(result_of(only, trials=1, bad=0), only)
    assert (told.words, told.share) == ("+0.2 m", 0.2 / yard.corridor)


def test_errors_and_lost_paths_are_told(route):
    assert deciding(result_of(route, trials=2, bad=0, errors=2), route).words == "failed to run"
    assert deciding(unplanned(), None).words == "no path"
    assert deciding(unplanned(trials=3), None).words == "no path in 3 of 3"


def test_settings_that_differ_on_a_scenario_are_named():
    few, many = ({"planner": "aco-improved", "set": {"ants": ants}} for ants in (5, 9))
    results = [unplanned("a", **few), unplanned("b", **many)]
    assert [told["path"] for told in dimensions(results, {})] == ["aco-improved, ants = 5", "aco-improved, ants = 9"]
    apart = [results[0], unplanned("b", **many, scenario="mars-gap")]
    assert [told["path"] for told in dimensions(apart, {})] == ["aco-improved", "aco-improved"]


def test_scales_of_one_scenario_are_told_apart():
    results = [unplanned("a", unit=2.0), unplanned("b")]
    told = [one["scenario"] for one in dimensions(results, {})]
    assert told[0] == "slalom-1000x600 at 2 m a unit"
    assert told[1].startswith("slalom-1000x600 at ")
    assert told[1] != told[0]


def lightness(colour):
    return sum(int(colour[i : i + 2], 16) for i in (1, 3, 5))


def test_more_margin_is_darker_on_its_own_side():
    for good in (True, False):
        side = 1.0 if good else -1.0
        shades = [lightness(shade(side * share, good)[0]) for share in (0.0, 0.1, 0.5, 1.0)]
        assert shades == sorted(shades, reverse=True)
        assert len(set(shades)) == 4
        assert shade(-side, good) == shade(0.0, good)  # enough other trials make up for the worst
        assert shade(5.0 * side, good) == shade(side, good)
    assert int(shade(1.0, True)[0][1:3], 16) < int(shade(1.0, True)[0][5:7], 16)
    assert int(shade(-1.0, False)[0][1:3], 16) > int(shade(-1.0, False)[0][5:7], 16)


def test_many_columns_over_few_rows_become_rows(yard):
    speeds, controllers = [f"{10 + 5 * i}km/h" for i in range(6)], ("lqr", "stanley")
    results, outcomes = cases(yard, *({"controller": one} for _ in speeds for one in controllers))
    results = [
        dataclasses.replace(one, case=msgspec.structs.replace(one.case, speed=speeds[i // 2]))
        for i, one in enumerate(results)
    ]
    told = matrix_data(results, outcomes)
    assert (told["down"], told["across"]) == (["speed"], ["controller"])
    assert len(told["rows"]) == 6
    assert all(cell for row in told["cells"] for cell in row)
    assert "path a.csv" in told["same"]
