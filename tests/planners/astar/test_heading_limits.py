import math

import pytest

from planners.astar.heading_limits import heading_limit, paper_heading_limit
from planners.units import STANDARD_GRAVITY

LATERAL = 0.6 * STANDARD_GRAVITY


@pytest.mark.parametrize(("kmh", "degrees"), [(15, 45.0), (30, 43.4), (45, 19.3), (60, 10.8)])
def test_the_papers_convention_gives_its_tables_for_a_wheelbase_of_8_93_m(kmh: float, degrees: float) -> None:
    assert math.degrees(paper_heading_limit(kmh / 3.6)) == pytest.approx(degrees, abs=0.05)


@pytest.mark.parametrize("wheelbase", [3.0, 4.5, 8.93])
@pytest.mark.parametrize(("kmh", "degrees"), [(30, 20.2), (45, 13.5), (60, 10.1)])
def test_what_a_vehicle_can_turn_in_half_a_second_at_0_6_g_does_not_depend_on_its_wheelbase(
    kmh: float, degrees: float, wheelbase: float
) -> None:
    limit = heading_limit(kmh / 3.6, wheelbase, LATERAL, math.radians(45.0))
    assert math.degrees(limit) == pytest.approx(degrees, abs=0.05)


def test_slowly_the_steering_limits_the_turn() -> None:
    speed, wheelbase, steering = 1.0, 4.5, math.radians(30.0)
    assert heading_limit(speed, wheelbase, LATERAL, steering) == pytest.approx(0.5 * math.tan(steering) / wheelbase)
