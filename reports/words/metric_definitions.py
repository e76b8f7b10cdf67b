"""What every metric is, in a line, and where its definition comes from: for those who repeat a result elsewhere."""

from __future__ import annotations

_ISO = "ISO 12188-2, MAVLink"
_PBN = "ICAO PBN, containment"
_TURNS = "geometry of turns"
_TRUCK = "paper 004, eq. 8"
_OURS = "trackworthy"

# By name: definition and source
METRIC_DEFINITIONS: dict[str, tuple[str, str]] = {
    "cross_track_mean": ("Mean of the signed distance to the path, left positive: the steady bias.", _ISO),
    "cross_track_rms": ("Root mean square of the distance to the path, weighted by the length flown or driven.", _ISO),
    "cross_track_p50": ("Distance to the path that is kept on half of the way.", _ISO),
    "cross_track_p95": ("Distance to the path that is kept on 95 % of the way.", "ICAO PBN, FTE 95 %"),
    "cross_track_p99": ("Distance to the path that is kept on 99 % of the way.", _ISO),
    "cross_track_max": ("Largest distance to the path; path that was not reached counts with its distance.", _ISO),
    "corridor_fraction": ("Share of the path followed within the corridor.", _PBN),
    "corridor_violation_count": ("How often the corridor was left.", _PBN),
    "corridor_violation_time": ("How long the vehicle was outside the corridor.", _PBN),
    "corridor_violation_distance": ("Length flown or driven outside the corridor.", _PBN),
    "corridor_violation_worst": ("How far outside the corridor at most.", _PBN),
    "completion": ("Share of the path that was followed, its waypoints passed in order.", _OURS),
    "heading_error_rms": ("Root mean square of heading minus the path's direction.", _OURS),
    "heading_error_max": ("Largest difference of heading and the path's direction.", _OURS),
    "course_error_rms": ("Root mean square of the course over the ground minus the path's direction.", _OURS),
    "course_error_max": ("Largest difference of the course over the ground and the path's direction.", _OURS),
    "altitude_error_rms": ("Root mean square of flown minus commanded altitude.", _OURS),
    "altitude_error_max": ("Largest difference of flown and commanded altitude.", _OURS),
    "speed_error_rms": ("Root mean square of flown or driven minus commanded speed.", _OURS),
    "speed_error_max": ("Largest difference of flown or driven and commanded speed.", _OURS),
    "frechet": ("Discrete Fréchet distance of track and path, every tenth of the corridor.", "Eiter and Mannila 1994"),
    "path_length": ("Length of the planned path.", _OURS),
    "track_length": ("Length flown or driven.", _OURS),
    "length_ratio": ("Length flown or driven over the length planned.", _OURS),
    "range_used": ("Length flown or driven over the scenario's longest path.", "paper 001, eq. 3"),
    "turn_angle_max_planned": ("Largest change of direction at a vertex of the path.", "the papers' own metric"),
    "turn_angle_max_flown": ("Largest change of course over the length of the path's median leg.", _OURS),
    "turn_radius_min": ("Smallest radius that the corridor and the legs beside a corner leave for its turn.", _TURNS),
    "turn_radius_required": ("Smallest radius that the vehicle can turn with, at its speed and in the wind.", _TURNS),
    "turn_margin": ("Radius that the tightest corner leaves, minus what the vehicle needs there.", _TURNS),
    "corner_cut_max": ("Largest distance to the path on the inside of a corner.", _OURS),
    "overshoot_max": ("Largest distance to the path on the outside of a corner.", _OURS),
    "bank_max": ("Largest bank to either side.", _OURS),
    "load_factor_max": ("Largest load factor, lift over weight.", _OURS),
    "stall_margin_min": ("Smallest difference of the stall's angle of attack and that flown.", _OURS),
    "control_saturation": ("Share of the time in which bank, steering, tyres or throttle were at their limit.", _OURS),
    "fuel_used": ("Fuel burned.", _OURS),
    "fuel_range": ("How far all fuel on board would last at the consumption measured.", _OURS),
    "steering_max": ("Largest angle of the front wheels.", _OURS),
    "steering_rate_max": ("Largest rate of the front wheels' angle.", _OURS),
    "lateral_acceleration_max": ("Largest acceleration to the side that the vehicle really had.", _TRUCK),
    "lateral_acceleration_demanded": ("Largest acceleration to the side asked for, v² times curvature.", _TRUCK),
    "lateral_acceleration_needed": ("Largest acceleration to the side that the path needs at that speed.", _TRUCK),
    "friction_use_max": ("Largest share of the tyres' grip that was used.", _OURS),
    "clearance_min": ("Smallest distance of the vehicle's outline to obstacles and map edge; negative inside.", _OURS),
    "incursion_count": ("How often the outline touched an obstacle or the map's edge.", _OURS),
    "incursion_time": ("How long the outline touched an obstacle or the map's edge.", _OURS),
    "incursion_depth": ("How deep the outline was in an obstacle or beyond the map's edge.", _OURS),
    "separation_min": ("Smallest distance of two vehicles of the fleet at the same time.", _OURS),
    "departure_delay_max": ("Longest that a vehicle of the fleet waits for its departure.", _OURS),
}  # fmt: skip
