import math
from dataclasses import replace

import jsbsim
import numpy as np
import pytest
from msgspec import structs
from pyproj import Geod

from planners.errors import InputError
from planners.frame import Frame
from sim.aircraft_file import load_aircraft
from sim.fixed_wing import STEP, FixedWing
from sim.jsbsim_model import load_model, start_in_equilibrium
from sim.vehicle import Command, Conditions, Pose
from sim.wind import Wind

V = 55.0
START = Pose(0.0, 0.0, 1000.0, 0.3)
FROM_ALL_SIDES = [Wind.blowing_from(10.0, direction) for direction in (0.0, 70.0, 160.0, 250.0)]


def fly(curvature, seconds, wind=None, altitude=1000.0, gradient=0.0, frame=None):
    conditions = Conditions(wind=wind or Wind(), frame=frame or Frame(0.0, 0.0))
    aircraft = FixedWing(load_aircraft("c172x"))
    states = [aircraft.reset(START, V, conditions, 0)]
    for _ in range(round(seconds / aircraft.period)):
        states.append(aircraft.step(Command(curvature, V, altitude + gradient * V * states[-1].t, gradient)))
    return states


def column(states, name):
    return np.array([getattr(state, name) for state in states])


def channel(states, name):
    return np.array([state.channels[FixedWing.channels.index(name)] for state in states])


@pytest.mark.parametrize("bank_deg", [-45.0, -30.0, -15.0, 15.0, 30.0, 45.0])
def test_a_coordinated_turn_has_its_radius(bank_deg):
    """V^2 / (g tan(bank)), within 1 %."""
    states = fly(9.8 * math.tan(math.radians(bank_deg)) / V**2, 100.0)[1000:]
    bank = channel(states, "bank").mean()
    assert math.degrees(bank) == pytest.approx(bank_deg, abs=1.0)
    x, y = column(states, "x"), column(states, "y")
    a = np.column_stack([2 * x, 2 * y, np.ones_like(x)])
    cx, cy, c = np.linalg.lstsq(a, x**2 + y**2, rcond=None)[0]
    radius = math.sqrt(c + cx**2 + cy**2)
    airspeed = column(states, "airspeed").mean()
    assert radius == pytest.approx(airspeed**2 / (9.8 * math.tan(abs(bank))), rel=0.01)
    assert channel(states, "load_factor").mean() == pytest.approx(1.0 / math.cos(bank), rel=0.01)
    assert np.abs(column(states, "z") - 1000.0).max() < 8.0


def test_left_curvature_turns_left_and_banks_left():
    states = fly(1 / 1000.0, 20.0)
    assert states[-1].course > START.course
    assert states[-1].channels[0] > 0.0
    assert states[-1].curvature == pytest.approx(1 / 1000.0, rel=0.05)


@pytest.mark.parametrize("wind", [Wind(), *FROM_ALL_SIDES])
def test_it_starts_in_equilibrium_on_its_course(wind):
    states = fly(0.0, 2.0, wind)
    assert column(states, "course") == pytest.approx(START.course, abs=2e-3)
    assert column(states, "airspeed") == pytest.approx(V, abs=0.1)
    assert column(states, "z") == pytest.approx(1000.0, abs=1.0)
    assert np.abs(channel(states, "sideslip")).max() < math.radians(0.2)
    assert np.abs(channel(states, "bank")).max() < math.radians(1.0)


@pytest.mark.parametrize("wind", FROM_ALL_SIDES)
def test_wind_displaces_an_uncontrolled_aircraft_as_the_wind_triangle_says(wind):
    """No loops closed: the stock aircraft, trimmed, is carried along; a wrong sign of wind would double the error."""
    fdm = load_model(load_aircraft("c172x"), STEP)
    frame = Frame(10.0, 20.0)
    start_in_equilibrium(fdm, START, frame.lat, frame.lon, V, wind)
    heading = math.pi / 2 - fdm["attitude/psi-rad"]
    seconds = 10.0
    for _ in range(round(seconds / STEP)):
        fdm.run()
    x, y = frame.to_local(np.array([fdm["position/lat-geod-deg"]]), np.array([fdm["position/long-gc-deg"]]))[0]
    assert x == pytest.approx((V * math.cos(heading) + wind.east) * seconds, abs=2.0)
    assert y == pytest.approx((V * math.sin(heading) + wind.north) * seconds, abs=2.0)
    assert math.atan2(y, x) == pytest.approx(START.course, abs=5e-3)


@pytest.mark.parametrize("direction", [43.8, 44.0, 45.0, 45.2])
def test_it_starts_where_jsbsims_trim_is_singular(direction):
    """Due east in 30 m/s from the north-east, trim would see 90 deg of sideslip."""
    aircraft = FixedWing(load_aircraft("c172x"))
    conditions = Conditions(wind=Wind.blowing_from(30.0, direction))
    state = aircraft.reset(Pose(0.0, 0.0, 1000.0, 0.0), V, conditions, 0)
    assert state.airspeed == pytest.approx(V, abs=1.0)
    later = [aircraft.step(Command(0.0, V, 1000.0)) for _ in range(60)][-1]
    assert later.airspeed == pytest.approx(V, abs=1.0)
    assert later.course == pytest.approx(0.0, abs=0.03)


def test_curvature_over_the_ground_is_kept_through_the_wind():
    states = fly(1 / 800.0, 100.0, Wind.blowing_from(10.0, 300.0))[100:]
    assert column(states, "curvature") == pytest.approx(1 / 800.0, rel=0.15)
    assert column(states, "ground_speed").max() - column(states, "ground_speed").min() > 15.0


def test_its_position_is_geodetic_truth():
    """Distance from the start by the geodesic equals the local frame's, after 2 minutes at 47 deg north."""
    frame = Frame(47.0, 8.0)
    state = fly(0.0, 120.0, frame=frame)[-1]
    lat, lon = frame.to_geographic(np.array([[state.x, state.y]]))[0]
    distance = Geod(ellps="WGS84").inv(8.0, 47.0, lon, lat)[2]
    assert math.hypot(state.x, state.y) == pytest.approx(distance, abs=0.01)
    # At height, over the ellipsoid below: R / (R + h) of the distance in the air
    assert distance == pytest.approx(V * 120.0 * 6.37e6 / 6.371e6, rel=2e-3)


def test_a_steady_climb_follows_its_slope():
    states = fly(0.0, 60.0, gradient=0.05)
    late = states[600:]
    slope = np.polyfit(column(late, "t") * V, column(late, "z"), 1)[0]
    assert slope == pytest.approx(0.05, rel=0.03)
    assert column(late, "airspeed") == pytest.approx(V, abs=2.0)


def test_bank_stops_at_its_limit_and_says_so():
    states = fly(1 / 50.0, 20.0)
    assert np.degrees(channel(states, "bank")).max() < 47.0
    assert np.degrees(channel(states[200:], "bank")).mean() == pytest.approx(45.0, abs=0.5)
    assert states[-1].saturated
    assert not fly(1 / 2000.0, 5.0)[-1].saturated


def test_bank_moves_no_faster_than_its_rate_limit():
    bank = np.degrees(channel(fly(1 / 50.0, 4.0), "bank"))
    rate = np.diff(bank) / FixedWing.period
    assert 25.0 < rate.max() < 40.0  # the command moves at 30 deg/s


def test_curvature_to_bank_uses_ground_speed_and_crab():
    """On course across a 20 m/s wind, tan(bank) = Vg^2 k / (g cos(crab))."""
    wind = Wind.blowing_from(20.0, 340.0)
    radius = 3000.0
    states = fly(1 / radius, 30.0, wind)[200:]
    crab = column(states, "heading") - column(states, "course")
    assert np.abs(crab).max() > math.radians(15.0)
    expected = np.arctan(column(states, "ground_speed") ** 2 / (radius * 9.8 * np.cos(crab)))
    assert channel(states, "bank").mean() == pytest.approx(expected.mean(), rel=0.03)


def test_stall_margin_is_the_angle_of_attack_that_remains():
    state = fly(0.0, 1.0)[-1]
    alpha, margin = state.channels[3], state.channels[4]
    assert math.degrees(alpha + margin) == pytest.approx(16.0)


def test_a_stall_is_a_fault():
    """With a wing that stalls at 1 deg of angle of attack, a turn at 45 deg of bank is one."""
    model = load_aircraft("c172x")
    weak = structs.replace(model, envelope=structs.replace(model.envelope, alpha_stall=1.0))
    aircraft = FixedWing(weak)
    aircraft.reset(START, V, Conditions(), 0)
    faults = [aircraft.step(Command(1 / 300.0, V, 1000.0)).fault for _ in range(200)]
    assert faults[0] == ""
    assert "stall" in faults


def test_a_step_of_the_slope_is_taken_up_gently():
    """Level, then 50 %: the aircraft climbs as it can, and pulls no more than a third of a g to get there."""
    aircraft = FixedWing(load_aircraft("c172x"))
    states = [aircraft.reset(START, V, Conditions(), 0)]
    for i in range(1200):
        states.append(aircraft.step(Command(0.0, V, 1000.0 + max(0, i - 200) * 1.4, 0.5 if i > 200 else 0.0)))
    assert channel(states, "load_factor").max() < 1.5
    assert channel(states, "load_factor").min() > 0.5
    assert column(states, "airspeed").min() > 45.0


def test_far_from_the_origin_course_and_heading_are_still_those_of_the_frame():
    """At 60 deg north, 150 km east of the origin, true north is 2.3 deg off the frame's y axis."""
    frame = Frame(60.0, 10.0)
    aircraft = FixedWing(load_aircraft("c172x"))
    pose = Pose(150_000.0, 20_000.0, 1000.0, 0.4)
    states = [aircraft.reset(pose, V, Conditions(frame=frame), 0)]
    states += [aircraft.step(Command(0.0, V, 1000.0)) for _ in range(200)]
    moved = math.atan2(states[-1].y - states[0].y, states[-1].x - states[0].x)
    assert moved == pytest.approx(0.4, abs=2e-3)
    assert states[-1].course == pytest.approx(moved, abs=2e-3)
    assert states[-1].heading == pytest.approx(moved, abs=5e-3)


def test_bank_responds_within_the_stated_time():
    limits = FixedWing(load_aircraft("c172x")).limits
    target = math.radians(10.0)
    bank = channel(fly(9.8 * math.tan(target) / V**2, 5.0), "bank")
    reached = np.argmax(bank > (1.0 - math.exp(-1.0)) * target) * FixedWing.period
    assert reached == pytest.approx(limits.response_time, abs=0.1)


def test_our_autopilot_in_place_of_its_own_changes_nothing_while_it_is_off():
    """The aircraft with our loops, not engaged, flies exactly as the one JSBSim ships."""
    stock = jsbsim.FGFDMExec(jsbsim.get_default_root_dir())
    stock.load_model("c172x")
    stock.set_dt(STEP)
    stock.disable_output()
    ours = load_model(load_aircraft("c172x"), STEP)
    for fdm in (stock, ours):
        start_in_equilibrium(fdm, START, 47.0, 8.0, V, Wind(5.0, 3.0))
        fdm["fcs/aileron-cmd-norm"] += 0.05
        for _ in range(600):
            fdm.run()
    for name in ("position/lat-geod-rad", "position/long-gc-rad", "position/geod-alt-ft", "attitude/phi-rad"):
        assert ours[name] == pytest.approx(stock[name], rel=1e-12)


def test_the_same_run_gives_the_same_bits():
    once, again = fly(1 / 700.0, 20.0, FROM_ALL_SIDES[0]), fly(1 / 700.0, 20.0, FROM_ALL_SIDES[0])
    assert once == again


def test_flying_into_the_ground_is_a_fault():
    aircraft = FixedWing(load_aircraft("c172x"))
    state = aircraft.reset(replace(START, z=30.0), V, Conditions(), 0)
    for _ in range(2000):
        state = aircraft.step(Command(0.0, V, -200.0))
        if state.fault:
            break
    assert state.fault == "ground"


@pytest.mark.parametrize(
    ("speed", "message"),
    [(15.0, "below its stall speed"), (30.0, "too close to its stall speed"), (90.0, "cannot hold")],
)
def test_a_speed_outside_the_envelope_is_refused(speed, message):
    with pytest.raises(InputError, match=message):
        FixedWing(load_aircraft("c172x")).reset(START, speed, Conditions(), 0)


def test_a_start_below_ground_and_a_wind_stronger_than_the_aircraft_are_refused():
    aircraft = FixedWing(load_aircraft("c172x"))
    with pytest.raises(InputError, match="not above the ground"):
        aircraft.reset(replace(START, z=0.0), V, Conditions(), 0)
    with pytest.raises(InputError, match="cannot be held"):
        aircraft.reset(START, V, Conditions(wind=Wind(north=80.0)), 0)
    with pytest.raises(InputError, match="no way"):
        aircraft.reset(START, V, Conditions(wind=Wind(-57.3, -17.7)), 0)
