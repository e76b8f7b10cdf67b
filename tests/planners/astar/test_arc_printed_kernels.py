import math

import numpy as np
import pytest

from planners.astar.arc_printed import sector_reach
from planners.astar.arc_printed_kernels import sector
from planners.astar.heading_limits import paper_heading_limit

X, Y, STEP = 100.5, 100.5, 45.0  # pixels


def children(blocked, reach, heading=0, step=STEP):
    """By direction from the heading, left positive: the ends of the radii, and which are free."""
    ends, free = np.empty((2 * reach + 1, 2)), np.empty(2 * reach + 1, np.bool_)
    sector(blocked, X, Y, heading, step, ends, free)
    order = [(i + 1) // 2 * (1 if i % 2 else -1) for i in range(2 * reach + 1)]
    return {turn: (ends[i], bool(free[i])) for i, turn in enumerate(order)}


@pytest.mark.parametrize(("kmh", "count"), [(15, 31), (30, 29), (45, 13), (60, 7)])
def test_a_sector_has_a_child_every_3_degrees_within_its_limit(kmh: float, count: int) -> None:
    reach = sector_reach(paper_heading_limit(kmh / 3.6))
    assert 2 * reach + 1 == count


@pytest.mark.parametrize("heading", [0, 17, 60, 119, -35])
def test_children_are_the_pixels_nearest_to_the_ends_of_the_radii(heading: int) -> None:
    found = children(np.zeros((200, 200), bool), 14, heading)
    assert sorted(found) == list(range(-14, 15))
    for turn, (end, free) in found.items():
        angle = math.radians(3.0 * (heading + turn))
        assert free
        assert np.abs(end - (X + STEP * math.cos(angle), Y + STEP * math.sin(angle))).max() <= 0.5 + 1e-9
        assert (end % 1.0 == 0.5).all()


def test_a_wall_on_the_left_moves_the_left_border() -> None:
    """Rows from 10 above the node on are blocked: no free child is more than asin(10 / 45) = 12.8 deg to the left."""
    blocked = np.zeros((200, 200), bool)
    blocked[111:] = True
    assert [turn for turn, (_, free) in children(blocked, 14).items() if free and turn > 0] == [1, 2, 3, 4]
    assert all(free for turn, (_, free) in children(blocked, 14).items() if turn <= 0)


def test_an_obstacle_within_hides_what_is_between_its_borders_and_leaves_both_sides() -> None:
    """From (19.5, +-5.5) to either side of the heading: atan(5.5 / 19.5) = 15.8 deg are hidden."""
    blocked = np.zeros((200, 200), bool)
    blocked[95:106, 120:125] = True
    hidden = sorted(turn for turn, (_, free) in children(blocked, 14).items() if not free)
    assert hidden == list(range(-5, 6))


def test_an_obstacle_beyond_the_arc_cuts_nothing() -> None:
    blocked = np.zeros((200, 200), bool)
    blocked[:, 147:] = True
    assert all(free for _, free in children(blocked, 14).values())
    blocked[:, 145:] = True
    assert not children(blocked, 14)[0][1]
