import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.single_track import Forces, Motion, SingleTrack, axle_forces, brush, rates, runge_kutta
from sim.truck_dynamic import MAN_KAT1

G = 9.80665
SPEEDS = [1.0, 5.0, 30.0 / 3.6, 45.0 / 3.6, 60.0 / 3.6, 25.0, 40.0]
# The same truck with its tyres the other way round oversteers
OVERSTEERING = SingleTrack(9522.0, 43_680.0, front=1.867, rear=2.633, front_stiffness=7.29, rear_stiffness=7.02)


def matrix(body, speed):
    """Rates of (sideways, yaw rate) by each of them, from the model by central differences."""
    straight, h = Motion(0.0, 0.0, 0.0, speed, 0.0, 0.0, 0.0), 1e-7

    def change(**off):
        now = straight._replace(**off)
        there = rates(body, now, axle_forces(body, now, 0.8), 0.0, 0.0)
        return np.array([there.sideways, there.yaw_rate])

    columns = [(change(**{name: h}) - change(**{name: -h})) / (2.0 * h) for name in ("sideways", "yaw_rate")]
    return np.column_stack(columns)


@pytest.mark.parametrize("speed", SPEEDS)
def test_linearized_it_is_rajamanis_matrix_and_stable(speed):
    """Rajamani 2012, sec. 2.3, lateral velocity and yaw rate."""
    body = MAN_KAT1
    front, rear = (load * c for load, c in zip(body.axle_loads(), (7.02, 7.29), strict=True))
    a, b, m, i = body.front, body.rear, body.mass, body.yaw_inertia
    expected = [
        [-(front + rear) / (m * speed), -speed - (a * front - b * rear) / (m * speed)],
        [-(a * front - b * rear) / (i * speed), -(a * a * front + b * b * rear) / (i * speed)],
    ]
    found = matrix(body, speed)
    assert found == pytest.approx(np.array(expected), rel=1e-4)
    assert np.linalg.eigvals(found).real.max() < -1.0


def test_an_oversteering_one_is_stable_up_to_its_critical_speed():
    """sqrt(-L / K) (Gillespie 1992, ch. 6)."""
    critical = math.sqrt(-OVERSTEERING.wheelbase / OVERSTEERING.understeer)
    assert np.linalg.eigvals(matrix(OVERSTEERING, 0.99 * critical)).real.max() < 0.0
    assert np.linalg.eigvals(matrix(OVERSTEERING, 1.01 * critical)).real.max() > 0.0


@pytest.mark.parametrize("speed", SPEEDS)
def test_the_courses_delay_is_twice_the_damping_ratio_over_the_natural_frequency(speed):
    found = matrix(MAN_KAT1, speed)
    assert MAN_KAT1.course_delay(speed) == pytest.approx(-np.trace(found) / np.linalg.det(found), rel=1e-4)


@given(st.floats(-3.0, 3.0), st.floats(2.0, 15.0), st.floats(0.05, 1.2))
def test_a_tyre_never_gives_more_than_the_friction_and_is_the_same_to_both_sides(slip, stiffness, friction):
    force = brush(slip, stiffness, friction)
    assert abs(force) <= friction
    assert force == -brush(-slip, stiffness, friction)
    assert force * slip >= 0.0


@pytest.mark.parametrize("friction", [0.1, 0.8])
def test_a_tyre_starts_at_its_stiffness_and_ends_at_the_friction(friction):
    """Pacejka 2012, sec. 3.2.1: full sliding from tan(slip) = 3 friction / stiffness; two thirds of it give 26 / 27."""
    stiffness = 7.0
    slide = 3.0 * friction / stiffness
    assert brush(1e-6, stiffness, friction) == pytest.approx(stiffness * 1e-6, rel=1e-4)
    assert brush(math.atan(2.0 / 3.0 * slide), stiffness, friction) == pytest.approx(26.0 / 27.0 * friction)
    assert brush(math.atan(slide) - 1e-9, stiffness, friction) == pytest.approx(friction)
    assert brush(1.5, stiffness, friction) == friction


def test_axle_loads_bear_the_weight_and_balance_about_the_centre_of_gravity():
    front, rear = MAN_KAT1.axle_loads()
    assert front + rear == pytest.approx(MAN_KAT1.mass * G)
    assert front * MAN_KAT1.front == pytest.approx(rear * MAN_KAT1.rear)


def test_without_force_it_flies_on_straight_and_keeps_turning():
    """Free of its tyres the centre of gravity goes straight on at its speed, however the body turns."""
    body, free = MAN_KAT1, Forces(0.0, 0.0)
    start = now = Motion(0.0, 0.0, 0.3, 10.0, -1.0, 0.5, 0.1)

    def centre(motion):
        return np.array(
            [motion.x + body.rear * math.cos(motion.heading), motion.y + body.rear * math.sin(motion.heading)]
        )

    for _ in range(100):
        now = runge_kutta(lambda motion: rates(body, motion, free, 0.0, 0.0), now, 0.02)
    c, s = math.cos(0.3), math.sin(0.3)
    expected = centre(start) + 2.0 * np.array([10.0 * c + 1.0 * s, 10.0 * s - 1.0 * c])
    assert centre(now) == pytest.approx(expected, abs=1e-6)
    assert now.heading == pytest.approx(0.3 + 0.5 * 2.0)


def test_the_truck_is_the_sum_of_project_chronos_parts():
    """chrono_models/vehicle/man: MAN_5t_Chassis, _BellcrankSolid3LinkAxle, _Solid3LinkAxle, _Wheel, _TMeasyTire."""
    wheel, spindle, knuckle = 30.0 + 104.0, 14.705 * 4.1, 145.6
    chassis, chassis_at = 7085.0, 1.748
    guides = 50.0 + 2.0 * 25.0  # the triangle and two links of each axle
    front = 405.0 + 2.0 * (spindle + knuckle + wheel) + 24.4 + 10.3 + guides + 2.0 * 10.0
    rear = 709.0 + 2.0 * (spindle + wheel) + guides
    mass = chassis + front + rear
    at = (chassis * chassis_at + rear * 4.5) / mass
    own = 29_395.0 + 21.31 + 330.0 + 4.0 * 17.87
    wheels = 2.0 * (spindle + knuckle + wheel) * 1.033**2 + 2.0 * (spindle + wheel) * 1.035**2
    inertia = own + wheels + chassis * (at - chassis_at) ** 2 + front * at**2 + rear * (4.5 - at) ** 2
    assert mass == pytest.approx(MAN_KAT1.mass, abs=1.0)
    assert at == pytest.approx(MAN_KAT1.front, abs=1e-3)
    assert MAN_KAT1.wheelbase == 4.5
    assert inertia == pytest.approx(MAN_KAT1.yaw_inertia, rel=1e-3)


def test_its_tyres_are_project_chronos_at_their_loads():
    """ChTMeasyTire::GuessTruck80Par: 7.4013 and 6.8505 times the load at the nominal load and at twice it."""
    nominal = 0.5 * 49_050.0 * (450.0 / 760.0) ** 0.8
    for load, stiffness in zip(MAN_KAT1.axle_loads(), (7.02, 7.29), strict=True):
        times = load / 2.0 / nominal
        assert 2.0 * 7.4013 - 6.8505 - (7.4013 - 6.8505) * times == pytest.approx(stiffness, abs=5e-3)
