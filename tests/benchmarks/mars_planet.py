"""Mars in JSBSim against closed forms: gravity, air, speed of sound, turns; and the natural modes of ares and c172x.

Run as `python tests/benchmarks/mars_planet.py`; prints what is flown, what is true and the difference.
"""

from __future__ import annotations

import math

import numpy as np

from planners.units import METRES_PER_FOOT
from sim.aircraft_file import load_aircraft
from sim.fixed_wing import STEP, FixedWing
from sim.jsbsim_model import load_model, start_in_equilibrium
from sim.modes import modes_of
from sim.planet import EARTH, MARS
from sim.planet_air import KILOGRAMS_PER_CUBIC_METRE, RANKINE_PER_KELVIN
from sim.vehicle import Command, Conditions, Pose
from sim.wind import Wind

AIRSPEED, HEIGHT = 140.0, 1500.0
TURN_TIME = 500.0  # [s]


def planet(lat: float, height: float) -> None:
    """Gravity, density and speed of sound at one place."""
    fdm = load_model(load_aircraft("ares"), STEP)
    start_in_equilibrium(fdm, Pose(0.0, 0.0, height, 0.0), lat, 0.0, AIRSPEED, Wind())
    fdm.run()
    temperature = fdm["atmosphere/T-R"] / RANKINE_PER_KELVIN
    rows = (
        ("gravity m/s^2", fdm["accelerations/gravity-ft_sec2"] * METRES_PER_FOOT, MARS.gravitation(lat, height)),
        ("density kg/m^3", fdm["atmosphere/rho-slugs_ft3"] * KILOGRAMS_PER_CUBIC_METRE, MARS.density(height)),
        ("speed of sound m/s", AIRSPEED / fdm["planet/mach"], MARS.speed_of_sound(temperature)),
    )
    for name, flown, true in rows:
        print(f"{lat:5.0f} deg {height:6.0f} m  {name:18s} {flown:9.5g} {true:9.5g} {100 * (flown / true - 1):+7.3f} %")


def turn(bank: float) -> None:
    """Radius of a steady turn at `bank` [rad] near the equator against V^2 / (g tan(bank))."""
    aircraft = FixedWing(load_aircraft("ares"))
    aircraft.reset(Pose(0.0, 0.0, HEIGHT, 0.0), AIRSPEED, Conditions(), 0)
    command = Command(MARS.gravity * math.tan(bank) / AIRSPEED**2, AIRSPEED, HEIGHT)
    states = [aircraft.step(command) for _ in range(round(TURN_TIME / aircraft.period))][1000:]
    x, y, flown, airspeed = np.array([(s.x, s.y, s.channels[0], s.airspeed) for s in states]).T
    cx, cy, c = np.linalg.lstsq(np.column_stack([2 * x, 2 * y, np.ones_like(x)]), x**2 + y**2, rcond=None)[0]
    radius = math.sqrt(c + cx**2 + cy**2)
    true = airspeed.mean() ** 2 / (MARS.gravity * math.tan(abs(flown.mean())))
    off = 100.0 * (radius / true - 1.0)
    print(f"turn at {math.degrees(bank):+.0f} deg: radius {radius:.0f} m, {true:.0f} m, {off:+.2f} %")


def modes() -> None:
    """The modes of both aircraft at home."""
    for name, home, speed, height in (("ares", MARS, AIRSPEED, HEIGHT), ("c172x", EARTH, 55.0, 1000.0)):
        for mode in modes_of(load_aircraft(name), home, speed, height):
            print(
                f"{name:6s} {mode.name:13s} damping {mode.damping:+.3f}, {mode.frequency:.4f} rad/s, "
                f"time constant {mode.time_constant:.1f} s, half time {mode.half_time:.1f} s"
            )


if __name__ == "__main__":
    for lat, height in ((0.0, 300.0), (0.0, 1500.0), (45.0, 1500.0), (0.0, 3000.0)):
        planet(lat, height)
    for bank_deg in (-40.0, -20.0, 20.0, 40.0):
        turn(math.radians(bank_deg))
    modes()
