import heapq

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from planners.astar.heap_kernels import pop, push


@given(st.lists(st.one_of(st.floats(-1e6, 1e6), st.none()), max_size=60))
def test_what_is_popped_is_what_heapq_pops(actions):
    """None pops; costs come in the same order, and each with its item."""
    costs, items, count = np.empty(60), np.empty(60, dtype=np.int64), 0
    expected, made = [], []
    for cost in actions:
        if cost is not None:
            count = push(costs, items, count, cost, len(made))
            made.append(cost)
            heapq.heappush(expected, cost)
        elif expected:
            assert costs[0] == heapq.heappop(expected)
            assert made[items[0]] == costs[0]
            count = pop(costs, items, count)
        assert count == len(expected)
    left = []
    while count:
        left.append(int(items[0]))
        count = pop(costs, items, count)
    assert [made[item] for item in left] == sorted(expected)
    assert len(set(left)) == len(left)
