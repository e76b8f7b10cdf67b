"""How much worse a metric may get before a check fails, stated for every metric that can get worse."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated

import msgspec

from planners.errors import InputError
from planners.typed_toml import suggestion

NotNegative = Annotated[float, msgspec.Meta(ge=0.0)]


class Limit(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A metric may worsen by the larger of `absolute` (angles in degrees) and `relative` times its old value."""

    absolute: NotNegative = 0.0
    relative: NotNegative = 0.0

    def allowed(self, old: float) -> float:
        """By how much a metric of value `old` may worsen."""
        return max(self.absolute, self.relative * abs(old))


# A mean or a percentile moves little for no reason; a maximum is decided by one sample. Absolute limits only keep
# values near zero from raising alarms.
DEFAULT_LIMITS = {
    "cross_track_rms": Limit(0.002, 0.05),
    "cross_track_p50": Limit(0.002, 0.05),
    "cross_track_p95": Limit(0.002, 0.05),
    "cross_track_p99": Limit(0.002, 0.05),
    "cross_track_max": Limit(0.005, 0.10),
    "corridor_fraction": Limit(0.001, 0.0),
    "corridor_violation_count": Limit(0.5, 0.0),
    "corridor_violation_time": Limit(0.1, 0.05),
    "corridor_violation_distance": Limit(1.0, 0.05),
    "corridor_violation_worst": Limit(0.005, 0.10),
    "completion": Limit(0.001, 0.0),
    "heading_error_rms": Limit(0.01, 0.05),
    "heading_error_max": Limit(0.05, 0.10),
    "course_error_rms": Limit(0.01, 0.05),
    "course_error_max": Limit(0.05, 0.10),
    "altitude_error_rms": Limit(0.05, 0.05),
    "altitude_error_max": Limit(0.1, 0.10),
    "speed_error_rms": Limit(0.01, 0.05),
    "speed_error_max": Limit(0.05, 0.10),
    "frechet": Limit(0.005, 0.10),
    "range_used": Limit(0.001, 0.01),
    "fuel_used": Limit(0.001, 0.02),
    "fuel_range": Limit(100.0, 0.02),
    "turn_angle_max_planned": Limit(0.5, 0.05),
    "turn_angle_max_flown": Limit(0.5, 0.10),
    "turn_radius_min": Limit(0.1, 0.05),
    "turn_radius_required": Limit(0.1, 0.05),
    "turn_margin": Limit(0.5, 0.05),
    "corner_cut_max": Limit(0.005, 0.10),
    "overshoot_max": Limit(0.005, 0.10),
    "bank_max": Limit(0.5, 0.05),
    "load_factor_max": Limit(0.02, 0.05),
    "stall_margin_min": Limit(0.2, 0.05),
    "control_saturation": Limit(0.005, 0.10),
    "clearance_min": Limit(0.05, 0.05),
    "incursion_count": Limit(0.5, 0.0),
    "incursion_time": Limit(0.05, 0.05),
    "incursion_depth": Limit(0.005, 0.10),
    "separation_min": Limit(1.0, 0.05),
    "departure_delay_max": Limit(1.0, 0.05),
    "steering_max": Limit(0.2, 0.05),
    "steering_rate_max": Limit(1.0, 0.10),
    "lateral_acceleration_max": Limit(0.05, 0.05),
    "lateral_acceleration_demanded": Limit(0.05, 0.10),
    "lateral_acceleration_needed": Limit(0.05, 0.05),
    "friction_use_max": Limit(0.005, 0.05),
}


NO_DIRECTION = ("cross_track_mean", "path_length", "track_length", "length_ratio")  # metrics that cannot get worse


def check_names(limits: Iterable[str], place: str) -> None:
    """Raises `InputError` for a metric that cannot get worse, or does not exist."""
    if unknown := next((name for name in limits if name not in DEFAULT_LIMITS), None):
        raise InputError(place, f"there is no metric {unknown!r} to check", suggestion(unknown, DEFAULT_LIMITS))
