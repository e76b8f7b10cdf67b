from itertools import permutations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from planners.assignment import assigned


def served(aircraft, targets, lengths, allowed=None):
    allowed = np.ones(len(lengths), dtype=bool) if allowed is None else np.array(allowed)
    return assigned(np.array(aircraft), np.array(targets), np.array(lengths, dtype=float), allowed).tolist()


@given(st.lists(st.floats(1.0, 100.0), min_size=12, max_size=12), st.booleans())
def test_it_is_the_best_of_all_assignments(lengths, turned):
    """Three aircraft and four targets, or the reverse, by brute force."""
    table = np.array(lengths).reshape(3, 4)
    many, few = np.indices((3, 4))[::-1] if turned else np.indices((3, 4))
    chosen = served(many.ravel(), few.ravel(), table.ravel())
    best = min(sum(table[i, j] for i, j in enumerate(order)) for order in permutations(range(4), 3))
    assert len(chosen) == 3
    assert table.ravel()[chosen].sum() <= best * (1.0 + 1e-6)
    assert len(set(few.ravel()[chosen])) == len(set(many.ravel()[chosen])) == 3


def test_as_many_as_possible_are_served_however_long_the_ways():
    """Aircraft 0 is next to target 0, but aircraft 1 can reach no other."""
    assert served([0, 0, 1], [0, 1, 0], [1.0, 1e6, 1e6]) == [1, 2]


def test_of_two_candidates_of_a_pair_the_shorter_that_is_allowed_is_flown():
    assert served([0, 0, 0], [0, 0, 0], [3.0, 1.0, 2.0], [True, False, True]) == [2]


def test_where_nothing_is_allowed_nobody_flies():
    assert served([0], [0], [1.0], [False]) == []
