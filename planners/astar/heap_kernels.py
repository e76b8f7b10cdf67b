"""A binary heap in two arrays: costs, and what they are the costs of (Cormen et al., ch. 6)."""

from __future__ import annotations

from planners.kernel import Floats, Ints, kernel


@kernel
def push(costs: Floats, items: Ints, count: int, cost: float, item: int) -> int:
    """Add `item` to the `count` there are; returns how many there are now. The arrays must have room."""
    k = count
    while k > 0:
        parent = (k - 1) >> 1
        if costs[parent] <= cost:
            break
        costs[k], items[k] = costs[parent], items[parent]
        k = parent
    costs[k], items[k] = cost, item
    return count + 1


@kernel
def pop(costs: Floats, items: Ints, count: int) -> int:
    """Remove the cheapest of `count`, which is the first; returns how many are left."""
    count -= 1
    cost, item, k = costs[count], items[count], 0
    while True:
        child = 2 * k + 1
        if child >= count:
            break
        if child + 1 < count and costs[child + 1] < costs[child]:
            child += 1
        if costs[child] >= cost:
            break
        costs[k], items[k] = costs[child], items[child]
        k = child
    costs[k], items[k] = cost, item
    return count
