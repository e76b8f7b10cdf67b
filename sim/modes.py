"""The natural modes of an aircraft, with no loops closed: how it swings, rolls and drifts about level flight."""

from __future__ import annotations

import math
from dataclasses import dataclass

import jsbsim
import numpy as np
import numpy.typing as npt

from sim.aircraft_file import Aircraft
from sim.fixed_wing import STEP
from sim.jsbsim_log import listening
from sim.jsbsim_model import load_model, start_in_equilibrium
from sim.planet import Planet
from sim.vehicle import Pose
from sim.wind import Wind

LONGITUDINAL = ("Vt", "Alpha", "Theta", "Q", "Alt")  # height, whose change of density stiffens a phugoid
LATERAL = ("Beta", "Phi", "P", "R")
Complexes = npt.NDArray[np.complex128]


@dataclass(frozen=True, slots=True)
class Mode:
    """A mode: `damping` ratio [1], natural `frequency` [rad/s] and `decay` [1/s] of its envelope, negative if it grows.

    A mode that does not swing has a damping ratio of 1 or -1, and its decay for frequency.
    """

    name: str
    damping: float
    frequency: float
    decay: float

    @property
    def time_constant(self) -> float:
        """Time [s] in which it decays by e; negative if it grows."""
        return 1.0 / self.decay

    @property
    def half_time(self) -> float:
        """Time [s] in which it halves; negative the time in which it doubles."""
        return math.log(2.0) / self.decay


def modes_of(aircraft: Aircraft, planet: Planet, speed: float, altitude: float) -> tuple[Mode, ...]:
    """Modes of `aircraft` trimmed level at `speed` [m/s] and `altitude` [m] on `planet`, surfaces and throttle held.

    Short period, phugoid, Dutch roll, roll and spiral: the eigenvalues of the longitudinal and the lateral block of
    JSBSim's linearisation (Stevens, Lewis and Johnson 2016, sect. 4.2), the coupling between them left out. A propeller
    keeps its speed, whose change JSBSim does not linearise: the phugoid of c172x is 15 % faster in flight. A roll and a
    spiral that swing together are one mode, "roll-spiral". Raises `InputError` where the aircraft has no equilibrium.
    """
    fdm = load_model(aircraft, STEP, planet)
    start_in_equilibrium(fdm, Pose(0.0, 0.0, altitude, 0.0), 0.0, 0.0, speed, Wind())
    with listening():
        model = jsbsim.FGLinearization(fdm)  # it stops the time of fdm, which nobody needs any more
    names, matrix = list(model.x_names), np.array(model.system_matrix)
    pitching, yawing = (
        np.linalg.eigvals(matrix[np.ix_(block, block)])
        for block in ([names.index(name) for name in states] for states in (LONGITUDINAL, LATERAL))
    )
    _, *pairs = pitching[np.argsort(np.abs(pitching))]  # without the slow drift in height
    slow, fast = np.split(np.array(pairs), 2)
    swinging = yawing[yawing.imag > 0.0]
    dutch_roll, *coupled = swinging[np.argsort(-np.abs(swinging))]
    single = sorted((float(root.real) for root in yawing if root.imag == 0.0), key=abs)
    return (
        _pair("short period", fast),
        _pair("phugoid", slow),
        _swing("Dutch roll", dutch_roll),
        *(_swing("roll-spiral", root) for root in coupled),
        *(
            Mode(name, math.copysign(1.0, -root), abs(root), -root)
            for name, root in zip(("spiral", "roll"), single, strict=False)
        ),
    )


def _pair(name: str, roots: Complexes) -> Mode:
    """Two roots as one second-order mode; two real ones decay as the slower."""
    frequency = math.sqrt(abs(roots[0] * roots[1]))
    return Mode(name, -float(roots.real.mean()) / frequency, frequency, -float(roots.real.max()))


def _swing(name: str, root: complex) -> Mode:
    return Mode(name, -root.real / abs(root), abs(root), -root.real)
