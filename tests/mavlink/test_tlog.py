import dataclasses
import io
import math
import struct

import numpy as np
import pytest
from pymavlink import mavutil

from mavlink.tlog import EPOCH, write_tlog
from planners.errors import InputError


def written(outcome):
    stream = io.BytesIO()
    write_tlog(outcome, stream)
    return stream.getvalue()


def read(outcome, folder):
    """Every message of the log, as pymavlink's own reader gives it."""
    file = folder / "a.tlog"
    file.write_bytes(written(outcome))
    log = mavutil.mavlink_connection(str(file), dialect="ardupilotmega")
    messages = []
    try:
        while (message := log.recv_msg()) is not None:
            messages.append(message)
    finally:
        log.close()
    return messages


def of(messages, kind):
    return [message for message in messages if message.get_type() == kind]


@pytest.fixture(scope="module")
def log(fly, tmp_path_factory):
    return read(fly(), tmp_path_factory.mktemp("tlog"))


def test_nothing_is_bad_and_all_is_ours(log):
    assert not of(log, "BAD_DATA")
    assert {(message.get_srcSystem(), message.get_srcComponent()) for message in log} == {(1, 1)}
    assert {message.get_msgbuf()[0] for message in log} == {0xFD}  # MAVLink 2
    sequence = [message.get_seq() for message in log]
    assert sequence == [i % 256 for i in range(len(log))]


def test_time_starts_at_the_epoch_and_never_goes_back(fly, log):
    data = written(fly())
    assert struct.unpack(">Q", data[:8])[0] == EPOCH * 1_000_000
    times = [message._timestamp for message in log]
    assert times == sorted(times)
    assert times[-1] == pytest.approx(EPOCH + 19.95)


def test_positions_within_a_centimetre_or_so(fly, log):
    track = fly().track
    positions = of(log, "GLOBAL_POSITION_INT")
    assert len(positions) == 201  # 10 Hz over 20 s, and the last sample
    for message in positions:
        i = int(np.argmin(np.abs(track["t"] - message.time_boot_ms / 1000.0)))
        [[x, y]] = track.frame.to_local(np.array([message.lat / 1e7]), np.array([message.lon / 1e7]))
        assert math.hypot(x - track["x"][i], y - track["y"][i]) < 0.012
        assert message.alt / 1000.0 == pytest.approx(track["z"][i], abs=1e-3)
        assert message._timestamp == pytest.approx(EPOCH + track["t"][i], abs=1e-5)


def test_starts_eastward_in_a_left_turn(log):
    position, attitude, hud = (of(log, kind)[0] for kind in ("GLOBAL_POSITION_INT", "ATTITUDE", "VFR_HUD"))
    assert (position.vx, position.vy, position.vz) == (0, 5000, -200)  # north, east, down [cm/s]
    assert position.hdg == 9000
    assert attitude.yaw == pytest.approx(math.pi / 2, abs=1e-6)
    assert attitude.yawspeed == pytest.approx(-50.0 / 503.0, rel=1e-3)
    assert attitude.roll == pytest.approx(-math.atan(2500 / (9.80665 * 500)), abs=1e-6)
    assert attitude.pitch == pytest.approx(0.05)
    assert (hud.airspeed, hud.groundspeed, hud.heading, hud.throttle) == (51.0, 50.0, 90, 65)


def test_the_receiver_has_place_and_course_over_ground(log):
    receiver, position = (of(log, kind)[0] for kind in ("GPS_RAW_INT", "GLOBAL_POSITION_INT"))
    assert receiver.fix_type == mavutil.mavlink.GPS_FIX_TYPE_3D_FIX
    assert (receiver.lat, receiver.lon, receiver.alt) == (position.lat, position.lon, position.alt)
    assert (receiver.vel, receiver.cog) == (5000, 9000)  # eastward


def test_guidance(log):
    guidance = of(log, "NAV_CONTROLLER_OUTPUT")[0]
    assert guidance.xtrack_error == pytest.approx(-3.0)  # right of the path
    assert guidance.nav_roll == pytest.approx(-math.degrees(math.atan(2500 / (9.80665 * 500))), abs=1e-3)
    assert guidance.nav_bearing == 90
    assert guidance.aspd_error == pytest.approx(-1.0)


def test_heartbeats_once_a_second(log):
    beats = of(log, "HEARTBEAT")
    assert len(beats) == 21  # one before the mission, then one a second
    assert {(beat.type, beat.autopilot, beat.custom_mode) for beat in beats} == {(1, 3, 10)}
    assert all(beat.base_mode & mavutil.mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED for beat in beats)
    assert all(beat.base_mode & mavutil.mavlink.MAV_MODE_FLAG_SAFETY_ARMED for beat in beats)


def test_system_time(log):
    assert of(log, "SYSTEM_TIME")[0].time_unix_usec == EPOCH * 1_000_000


def test_the_plan_comes_first(fly, log):
    path = fly().path
    [count] = of(log, "MISSION_COUNT")
    items = of(log, "MISSION_ITEM_INT")
    assert count.count == len(items) == len(path.simplify(3.0)) + 1
    assert [item.seq for item in items] == list(range(len(items)))
    assert log.index(items[-1]) < log.index(of(log, "GLOBAL_POSITION_INT")[0])
    for item, vertex in ((items[0], 0), (items[1], 0), (items[-1], -1)):
        [[x, y]] = path.frame.to_local(np.array([item.x / 1e7]), np.array([item.y / 1e7]))
        assert math.hypot(x - path.points[vertex, 0], y - path.points[vertex, 1]) < 0.012
        assert item.z == 400.0
        assert (item.frame, item.command) == (0, 16)


def test_a_truck_is_a_rover_without_roll(fly, tmp_path):
    outcome = fly(kind="ground", seconds=2.0)
    columns = [i for i, name in enumerate(outcome.track.columns) if name not in ("bank", "pitch", "throttle")]
    track = dataclasses.replace(
        outcome.track, columns=tuple(outcome.track.columns[i] for i in columns), data=outcome.track.data[:, columns]
    )
    log = read(dataclasses.replace(outcome, track=track), tmp_path)
    assert of(log, "HEARTBEAT")[0].type == 10
    assert of(log, "ATTITUDE")[0].roll == 0.0
    assert of(log, "ATTITUDE")[0].pitch == pytest.approx(math.atan2(2.0, 50.0))


def test_samples_that_are_not_numbers_are_left_out(fly, tmp_path):
    outcome = fly(seconds=2.0)
    data = np.array(outcome.track.data)
    data[-3:] = math.nan
    log = read(dataclasses.replace(outcome, track=dataclasses.replace(outcome.track, data=data)), tmp_path)
    assert not of(log, "BAD_DATA")
    assert of(log, "GLOBAL_POSITION_INT")[-1].time_boot_ms == 1800


@pytest.mark.parametrize("count", [0, 1, 2])
def test_short_tracks(fly, tmp_path, count):
    outcome = fly(seconds=2.0)
    track = dataclasses.replace(outcome.track, data=outcome.track.data[:count])
    log = read(dataclasses.replace(outcome, track=track), tmp_path)
    assert len(of(log, "GLOBAL_POSITION_INT")) == count


def test_what_does_not_fit_is_clamped(fly, tmp_path):
    outcome = fly(seconds=1.0)
    data = np.array(outcome.track.data)
    data[:, outcome.track.columns.index("ground_speed")] = 900.0
    log = read(dataclasses.replace(outcome, track=dataclasses.replace(outcome.track, data=data)), tmp_path)
    assert of(log, "GLOBAL_POSITION_INT")[0].vy == 32767


def test_same_run_same_bytes(fly):
    assert written(fly()) == written(fly())


def test_a_local_path_has_no_log(fly):
    with pytest.raises(InputError, match="no geographic origin"):
        written(fly(frame=None))
