"""The long form of a built-in campaign."""

import pytest

from campaigns.campaign import load_campaign
from campaigns.full import FULL, find_campaign
from campaigns.ready import make_ready
from planners.errors import InputError


@pytest.mark.parametrize("name", FULL)
def test_has_all_of_its_parts(name):
    whole, parts = find_campaign(name), [load_campaign(part) for part in FULL[name]]
    assert find_campaign(name.removesuffix("-full"), full=True) == whole
    assert whole.trials == sum(part.trials for part in parts)
    assert len(whole.searches) == sum(len(part.searches) for part in parts)
    assert whole.claims == tuple(claim for part in parts for claim in part.claims)
    assert len({one.name for one in (*whole.cases, *whole.searches)}) == len(whole.cases) + len(whole.searches)
    assert {part.seed for part in parts} == {whole.seed}


def test_a_case_keeps_its_name_so_that_it_can_be_run_alone():
    whole = find_campaign("papers", full=True)
    (one,) = find_campaign("papers", [whole.cases[0].name], full=True).cases
    assert one == whole.cases[0]
    assert make_ready(find_campaign("papers-full", [one.name]))[0].case.name == one.name


def test_says_what_is_not_there():
    with pytest.raises(InputError, match="has no long form; papers has one"):
        find_campaign("quickstart", full=True)
    with pytest.raises(InputError, match="it has no case 'x'"):
        find_campaign("papers", ["x"], full=True)
