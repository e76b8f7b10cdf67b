"""How far a ground vehicle may turn from one steering action to the next, at any speed."""

from __future__ import annotations

import math
from typing import Literal

from planners.units import STANDARD_GRAVITY

LATERAL = 0.6  # [g] paper 004, eq. 8
STEP_TIME = 0.5  # [s] paper 004, section 2.2: the steering acts at 2 Hz
PAPER_WHEELBASE = 8.93  # [m] with which eq. 8 gives two of the three limits in the paper's Table 1

Convention = Literal["paper", "kinematic"]


def heading_limit(
    speed: float, wheelbase: float, lateral: float, steering_limit: float, convention: Convention = "kinematic"
) -> float:
    """The largest heading change [rad] of one step at `speed` [m/s].

    `wheelbase` [m], `lateral` [m/s^2], `steering_limit` [rad] at the front wheels.

    "paper": the front-wheel angle of paper 004's eq. 8, delta <= a L / v^2, taken as a heading change as its Tables 1
    and 2 do. "kinematic": what a bicycle (paper 004, eq. 7) turns within `STEP_TIME` at the largest curvature that
    both limits leave; a / v * `STEP_TIME` where the lateral limit is the tighter one.
    """
    if convention == "paper":
        return min(lateral * wheelbase / speed**2, steering_limit)
    return curvature_limit(speed, wheelbase, lateral, steering_limit) * speed * STEP_TIME


def curvature_limit(speed: float, wheelbase: float, lateral: float, steering_limit: float) -> float:
    """The largest curvature [1/m] of the rear axle's path: a / v^2, or tan(delta) / L of the steering."""
    return min(lateral / speed**2, math.tan(steering_limit) / wheelbase)


def paper_heading_limit(speed: float) -> float:
    """The heading limit [rad] of paper 004 at `speed` [m/s]: 43.4, 19.3 and 10.8 deg at 30, 45 and 60 km/h.

    Its Table 1 prints 42.3 deg at 30 km/h, which comes out of no wheelbase that gives the other two.
    """
    return heading_limit(speed, PAPER_WHEELBASE, LATERAL * STANDARD_GRAVITY, math.radians(45.0), "paper")
