"""A run as a telemetry log (.tlog), which MAVExplorer, QGroundControl and Mission Planner replay.

The format is Mission Planner's: before every MAVLink message, as it came over the wire, its time in
microseconds since 1970, eight bytes, big-endian. Messages: https://mavlink.io/en/messages/common.html.
"""

from __future__ import annotations

import math
import struct
from typing import BinaryIO

import numpy as np
from pymavlink.dialects.v20 import ardupilotmega as mav

from mavlink.telemetry import Sample, samples
from planners.errors import InputError
from planners.frame import Frame
from tracking.outcome import Outcome

EPOCH = 1_577_836_800  # [s] 2020-01-01T00:00:00Z, the time every run starts at: the same run is the same file
SYSTEM, COMPONENT = 1, 1
_CLIENT = (255, 190)  # the usual ids of a ground station and its mission planner
_AUTO = 10  # custom_mode of AUTO in ArduPlane and in Rover
_PLAN_DETAIL = 0.1  # of the corridor: how far the mission's polyline may stand off the path
_MOST_ITEMS = 5000  # MISSION_COUNT counts to 65535, but no client enjoys that
_INT16, _INT32 = 32767, 2**31 - 1
_UNKNOWN, _UNKNOWN_COUNT = 65535, 255  # what MAVLink takes for "not known"


def write_tlog(outcome: Outcome, stream: BinaryIO) -> None:
    """Write the mission and 10 Hz of telemetry of `outcome` to `stream`.

    Heights are those of the track (above the ellipsoid, where MAVLink means the sea's level). Roll is
    positive to the right and yaw clockwise from north, as MAVLink has them; the cross-track error stays
    positive to the left, as ArduPilot reports it (AP_L1_Control: A_air % AB). Raises `InputError` for a path
    without a place on the planet.
    """
    frame = outcome.track.frame or outcome.path.frame
    if frame is None:
        raise InputError(outcome.path.name, "has no geographic origin, which a .tlog needs", "export CSV instead")
    log = _Log(stream)
    link = mav.MAVLink(log, srcSystem=SYSTEM, srcComponent=COMPONENT)
    _heartbeat(link, outcome)
    _mission(link, outcome, frame)
    told = -math.inf
    for sample in samples(outcome, frame):
        log.seconds = sample.t
        if sample.t >= told + 1.0 - 1e-6:
            _heartbeat(link, outcome)
            told = sample.t
        _telemetry(link, sample)


class _Log:
    """The file-like end of a link: puts the time before every message."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self.seconds = 0.0

    @property
    def microseconds(self) -> int:
        return EPOCH * 1_000_000 + round(self.seconds * 1e6)

    def write(self, message: bytes) -> None:
        self._stream.write(struct.pack(">Q", self.microseconds) + message)


def _heartbeat(link: mav.MAVLink, outcome: Outcome) -> None:
    plane = outcome.limits.kind == "fixed-wing"
    link.heartbeat_send(
        mav.MAV_TYPE_FIXED_WING if plane else mav.MAV_TYPE_GROUND_ROVER,
        mav.MAV_AUTOPILOT_ARDUPILOTMEGA,
        mav.MAV_MODE_FLAG_SAFETY_ARMED | mav.MAV_MODE_FLAG_AUTO_ENABLED | mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED,
        _AUTO,
        mav.MAV_STATE_ACTIVE,
    )


def _mission(link: mav.MAVLink, outcome: Outcome, frame: Frame) -> None:
    """The plan as a client would have downloaded it; item 0 is home, as ArduPilot has it."""
    path = outcome.path
    kept = path.simplify(_PLAN_DETAIL * outcome.corridor)
    if len(kept) > _MOST_ITEMS:
        kept = kept[np.unique(np.linspace(0, len(kept) - 1, _MOST_ITEMS).astype(int))]
    places = frame.to_geographic(path.xy[kept])
    heights = path.z[kept] if path.z is not None else np.full(len(kept), _height(outcome))
    rows = [(*places[0], heights[0]), *zip(*places.T, heights, strict=True)]
    link.mission_count_send(*_CLIENT, len(rows), mav.MAV_MISSION_TYPE_MISSION)
    for seq, (lat, lon, height) in enumerate(rows):
        link.mission_item_int_send(
            *_CLIENT, seq, mav.MAV_FRAME_GLOBAL, mav.MAV_CMD_NAV_WAYPOINT, int(seq == 1), 1, 0.0, 0.0, 0.0, math.nan,
            round(lat * 1e7), round(lon * 1e7), float(height), mav.MAV_MISSION_TYPE_MISSION,
        )  # fmt: skip


def _height(outcome: Outcome) -> float:
    """The commanded height [m] of a path without heights."""
    commanded = outcome.track["altitude_command"]
    finite = commanded[np.isfinite(commanded)]
    return float(finite[0]) if len(finite) else 0.0


def _telemetry(link: mav.MAVLink, now: Sample) -> None:
    boot_ms = round(now.t * 1000.0)
    link.system_time_send(EPOCH * 1_000_000 + round(now.t * 1e6), boot_ms)
    link.global_position_int_send(
        boot_ms, round(now.lat * 1e7), round(now.lon * 1e7), _int32(now.z * 1e3), _int32(now.height_gained * 1e3),
        _int16(now.north_speed * 100.0), _int16(now.east_speed * 100.0), _int16(-now.climb_rate * 100.0),
        round(now.compass * 100.0) % 36000,
    )  # fmt: skip
    # Most tools take the place from the receiver; its accuracy and satellites are unknown, for there are none.
    link.gps_raw_int_send(
        EPOCH * 1_000_000 + round(now.t * 1e6), mav.GPS_FIX_TYPE_3D_FIX, round(now.lat * 1e7), round(now.lon * 1e7),
        _int32(now.z * 1e3), _UNKNOWN, _UNKNOWN, min(_UNKNOWN - 1, round(now.ground_speed * 100.0)),
        round(math.degrees(math.atan2(now.east_speed, now.north_speed)) * 100.0) % 36000, _UNKNOWN_COUNT,
    )  # fmt: skip
    link.attitude_send(boot_ms, now.roll, now.pitch, now.yaw, now.roll_rate, now.pitch_rate, now.yaw_rate)
    link.vfr_hud_send(
        now.airspeed,
        now.ground_speed,
        round(now.compass) % 360,
        round(100.0 * now.throttle),
        now.z,
        now.climb_rate,
    )
    link.nav_controller_output_send(
        now.roll_wanted, 0.0, _int16(now.path_bearing), _int16(now.path_bearing),
        min(65535, max(0, round(now.distance_left))), now.altitude_error, now.speed_error, now.cross_track,
    )  # fmt: skip


def _int16(value: float) -> int:
    return max(-_INT16, min(_INT16, round(value)))


def _int32(value: float) -> int:
    return max(-_INT32, min(_INT32, round(value)))
