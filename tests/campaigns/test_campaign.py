import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from campaigns.campaign import BUILT_IN_CAMPAIGNS, load_campaign
from campaigns.case import Case
from campaigns.conditions import WindKeys
from campaigns.distribution import Distribution
from campaigns.expand import expanded
from planners.errors import InputError

HEAD = 'name = "test"\n'
CASE = '[[case]]\npath = "line.csv"\nvehicle = "truck"\n'


def load(tmp_path, text, **options):
    file = tmp_path / "campaign.toml"
    file.write_text(text)
    return load_campaign(str(file), **options)


def refused(tmp_path, text, **options):
    """The one line that says why, without the file's name, with which it begins."""
    with pytest.raises(InputError) as caught:
        load(tmp_path, text, **options)
    line, file = str(caught.value), str(tmp_path / "campaign.toml")
    assert line.startswith(f"{file}: ")
    assert "\n" not in line
    return line.removeprefix(f"{file}: ")


def names(campaign):
    return [case.name for case in campaign.cases]


# Lists


def test_lists_multiply_out_in_the_order_in_which_they_are_written(tmp_path):
    text = CASE + 'controller = ["lqr", "l1"]\nspeed = [10, "30km/h"]\nconditions.latency = [0, 0.2]\n'
    found = [(c.controller, c.speed, c.conditions.latency) for c in load(tmp_path, HEAD + text).cases]
    assert found == [
        ("lqr", 10.0, 0.0), ("lqr", 10.0, 0.2), ("lqr", "30km/h", 0.0), ("lqr", "30km/h", 0.2),
        ("l1", 10.0, 0.0), ("l1", 10.0, 0.2), ("l1", "30km/h", 0.0), ("l1", "30km/h", 0.2),
    ]  # fmt: skip
    swapped = CASE + 'speed = [10, "30km/h"]\ncontroller = ["lqr", "l1"]\n'
    assert [(c.speed, c.controller) for c in load(tmp_path, HEAD + swapped).cases] == [
        (10.0, "lqr"), (10.0, "l1"), ("30km/h", "lqr"), ("30km/h", "l1"),
    ]  # fmt: skip


def test_cases_have_names_that_tell_them_apart(tmp_path):
    text = (
        CASE + 'controller = ["lqr", "l1"]\nspeed = [10, 12.5]\nconditions.wind = ["3@270", "3@90"]\ntrials = [1, 5]\n'
    )
    found = names(load(tmp_path, HEAD + text))
    assert len(set(found)) == 16
    assert found[0] == "line lqr 10 trials 1 3@270"
    assert found[-1] == "line l1 12.5 trials 5 3@90"


def test_one_value_is_one_case_with_a_plain_name(tmp_path):
    assert names(load(tmp_path, HEAD + CASE + "speed = 10\n")) == ["line"]
    assert names(load(tmp_path, HEAD + CASE + 'name = "road"\nspeed = [10, 12]\n')) == ["road 10", "road 12"]


def test_blocks_stand_one_after_the_other(tmp_path):
    other = '[[case]]\nname = "other"\nscenario = "s.toml"\nplanner = "straight"\nvehicle = ["truck", "c172x"]\n'
    assert names(load(tmp_path, HEAD + CASE + other)) == ["line", "other truck", "other c172x"]


def test_requirements_are_a_list_and_not_multiplied(tmp_path):
    both = ("cross_track_p95 <= 1", "completion >= 1")
    cases = load(tmp_path, HEAD + CASE + f"speed = [10, 12]\nrequire = {list(both)}\n").cases
    assert [case.require for case in cases] == [both, both]


def test_distributions_are_not_multiplied(tmp_path):
    text = CASE + (
        "conditions.mass = { normal = [1.0, 0.1] }\n"
        "conditions.wind = { speed = { weibull = [2.0, 8.0] }, from = { uniform = [0, 360] } }\n"
    )
    (case,) = load(tmp_path, HEAD + text).cases
    assert case.conditions.mass == Distribution(normal=(1.0, 0.1))
    assert case.conditions.wind == WindKeys(Distribution(weibull=(2.0, 8.0)), Distribution(uniform=(0.0, 360.0)))


def test_a_list_of_distributions_stands_for_a_case_each(tmp_path):
    text = CASE + "conditions.mass = [{ normal = [1, 0.1] }, { uniform = [0.9, 1.1] }, 1.2]\n"
    cases = load(tmp_path, HEAD + text).cases
    masses = [Distribution(normal=(1.0, 0.1)), Distribution(uniform=(0.9, 1.1)), 1.2]
    assert [case.conditions.mass for case in cases] == masses
    assert len({case.name for case in cases}) == 3


def test_conditions_of_one_case_are_not_those_of_the_next(tmp_path):
    cases = load(tmp_path, HEAD + CASE + "conditions.latency = [0.1, 0.2]\nconditions.mass = 1.1\n").cases
    assert [(case.conditions.latency, case.conditions.mass) for case in cases] == [(0.1, 1.1), (0.2, 1.1)]


SETTINGS = {
    "speed": st.integers(1, 40),
    "controller": st.sampled_from(["lqr", "l1", "stanley"]),
    "vehicle": st.sampled_from(["truck", "c172x"]),
    "plan_seed": st.integers(0, 99),
    "trials": st.integers(1, 99),
}
CONDITIONS = {"latency": st.integers(0, 60), "mass": st.integers(1, 100), "wind": st.sampled_from(["1@0", "2@0"])}


def some_lists(settings):
    one_or_more = {
        key: st.one_of(value, st.lists(value, min_size=1, max_size=3, unique=True)) for key, value in settings.items()
    }
    return st.fixed_dictionaries({}, optional=one_or_more)


@given(some_lists(SETTINGS), some_lists(CONDITIONS))
def test_there_are_as_many_cases_as_the_product_of_the_lengths(settings, conditions):
    block = {"path": "line.csv", "vehicle": "truck", **settings, "conditions": conditions}
    before = repr(block)
    cases = expanded(block, "file", Case)
    lists = [value for value in (*settings.values(), *conditions.values()) if isinstance(value, list)]
    assert len(cases) == math.prod(len(values) for values in lists)
    assert len({case.name for case in cases}) == len(cases)
    assert len({str((c.speed, c.controller, c.vehicle, c.plan_seed, c.trials, c.conditions)) for c in cases}) == len(
        cases
    )
    assert repr(block) == before


def test_an_empty_list_leaves_no_case(tmp_path):
    empty = "an empty list stands for no case"
    assert refused(tmp_path, HEAD + CASE + "speed = []\n").startswith(f"case[0]: speed: {empty}")
    wind = HEAD + CASE + "speed = [10, 12]\nconditions.wind = []\n"
    assert refused(tmp_path, wind).startswith(f"case[0]: conditions.wind: {empty}")
    assert refused(tmp_path, HEAD + "case = []\n").startswith("it has no cases")
    assert refused(tmp_path, HEAD).startswith("it has no cases")


def test_an_empty_list_does_not_vanish_beside_other_cases(tmp_path):
    text = HEAD + CASE + "speed = []\n" + CASE.replace("line", "other")
    assert "case[0]" in refused(tmp_path, text)


def test_a_list_of_paths_is_named_by_its_paths(tmp_path):
    text = '[[case]]\npath = ["a.csv", "b.csv"]\nvehicle = "truck"\n'
    assert names(load(tmp_path, HEAD + text)) == ["a", "b"]


# What cannot be


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("sead = 1\n" + CASE, "unknown key 'sead'; did you mean 'seed'?"),
        (CASE + "speeed = 10\n", "case[0]: unknown key 'speeed'; did you mean 'speed'?"),
        (CASE + "speeed = [10, 12]\n", "case[0]: unknown key 'speeed'; did you mean 'speed'?"),
        (CASE + CASE + "corridoor = 1\n", "case[1]: unknown key 'corridoor'; did you mean 'corridor'?"),
        (CASE + "conditions.latencee = 1\n", "case[0]: conditions: unknown key 'latencee'; did you mean 'latency'?"),
        (CASE + "conditions.massa = [1, 2]\n", "case[0]: conditions: unknown key 'massa'; did you mean 'mass'?"),
        (
            CASE + "conditions.mass = { normel = [1, 2] }\n",
            "case[0]: conditions.mass: unknown key 'normel'; did you mean 'normal'?",
        ),
        (
            CASE + "conditions.mass = [1.0, { weibul = [1, 2] }]\n",
            "case[0]: conditions.mass: unknown key 'weibul'; did you mean 'weibull'?",
        ),
        (
            CASE + "conditions.turbulence = { unifrom = [1, 2] }\n",
            "case[0]: conditions.turbulence: unknown key 'unifrom'; did you mean 'uniform'?",
        ),
        (
            CASE + "conditions.wind = { speed = 3, form = 270 }\n",
            "case[0]: conditions.wind: unknown key 'form'; did you mean 'from'?",
        ),
        (
            CASE + "conditions.wind.speed = { normol = [1, 2] }\n",
            "case[0]: conditions.wind.speed: unknown key 'normol'; did you mean 'normal'?",
        ),
        (
            CASE + "conditions.gust = { duratoin = 3 }\n",
            "case[0]: conditions.gust: unknown key 'duratoin'; did you mean 'duration'?",
        ),
        (
            "check.cross_track_rmz = { absolute = 1 }\n" + CASE,
            "check: there is no metric 'cross_track_rmz' to check; did you mean 'cross_track_rms'?",
        ),
        (
            "check.cross_track_rms = { absolut = 1 }\n" + CASE,
            "check.cross_track_rms: unknown key 'absolut'; did you mean 'absolute'?",
        ),
    ],
)
def test_an_unknown_key_is_refused_with_its_place_and_the_nearest_name(tmp_path, text, line):
    assert refused(tmp_path, HEAD + text) == line


@pytest.mark.parametrize(
    ("text", "place"),
    [
        (CASE + "trials = 0\n", "case[0]: trials: "),
        (CASE + "trials = [1, 1.5]\n", "case[0]: trials: "),
        (CASE + "pass_share = 1.1\n", "case[0]: pass_share: "),
        (CASE + "pass_share = nan\n", "case[0]: pass_share: "),
        (CASE + 'expect = "maybe"\n', "case[0]: expect: "),
        (CASE + 'conditions.turbulence = "strong"\n', "case[0]: conditions.turbulence: "),
        (CASE + "conditions.mass = { normal = [1] }\n", "case[0]: conditions.mass.normal: "),
        (CASE + "conditions.wind = { speed = [1, 2] }\n", "case[0]: conditions.wind.speed: "),
        (CASE + "speed = [[1, 2], [3]]\n", "case[0]: speed: "),
        (CASE + "conditions = [{ mass = 1 }, { mass = 2 }]\n", "case[0]: conditions: "),
        (CASE + "conditions = 3\n", "case[0]: conditions: "),
        ('[[case]]\npath = "a.csv"\n', "case[0]: 'vehicle' is missing"),
        ("timeout = 0\n" + CASE, "timeout: "),
        ("timeout = nan\n" + CASE, "timeout: "),
        ('keep_tracks = "some"\n' + CASE, "keep_tracks: "),
        ("check.cross_track_rms = { relative = -0.1 }\n" + CASE, "check.cross_track_rms: relative: "),
        ("seed = 1.5\n" + CASE, "seed: "),
    ],
)
def test_a_value_of_the_wrong_kind_is_refused_with_its_place(tmp_path, text, place):
    assert refused(tmp_path, HEAD + text).startswith(place)


def test_two_cases_of_one_name_are_refused(tmp_path):
    assert refused(tmp_path, HEAD + CASE + CASE) == "two cases are called 'line'; give one of their blocks another name"
    assert "two cases are called 'line 10'" in refused(tmp_path, HEAD + CASE + "speed = [10, 12, 10.0]\n")


def test_what_is_no_toml_and_what_is_not_there_are_refused(tmp_path):
    assert refused(tmp_path, HEAD + "[[case\n").startswith("it is not TOML")
    with pytest.raises(InputError, match="there is no such file"):
        load_campaign(str(tmp_path / "none.toml"))
    with pytest.raises(InputError, match=r"there is no campaign 'quikstart'; choose papers, quickstart"):
        load_campaign("quikstart")


# The file


def test_a_file_leaves_out_what_has_a_default(tmp_path):
    bare = load(tmp_path, HEAD + CASE)
    assert (bare.name, bare.title, bare.seed, bare.keep_tracks, bare.timeout) == ("test", "test", 0, "worst", 300.0)
    assert bare.check == {}
    assert bare.folder == tmp_path
    text = 'title = "A title"\nseed = 5\nkeep_tracks = "all"\ntimeout = 9\ncheck.frechet = { absolute = 2 }\n'
    full = load(tmp_path, HEAD + text + CASE)
    assert (full.title, full.seed, full.keep_tracks, full.timeout) == ("A title", 5, "all", 9.0)
    assert full.check["frechet"].absolute == 2.0


def test_trials_are_those_of_all_cases(tmp_path):
    assert load(tmp_path, HEAD + CASE + "trials = [3, 4]\nspeed = [10, 12]\n").trials == 14


def test_only_the_cases_asked_for(tmp_path):
    text = HEAD + CASE + "speed = [10, 12, 14]\n"
    assert names(load(tmp_path, text, only=["line 14", "line 10"])) == ["line 10", "line 14"]
    assert refused(tmp_path, text, only=["line 11"]).startswith("it has no case 'line 11'; did you mean 'line 1")


@pytest.mark.parametrize("name", BUILT_IN_CAMPAIGNS)
def test_every_built_in_campaign_loads(name):
    campaign = load_campaign(name)
    assert campaign.name == name
    assert all((campaign.folder / case.path).is_file() for case in campaign.cases if case.path)
