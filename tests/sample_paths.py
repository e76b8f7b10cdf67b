"""Paths that tests and benchmarks share."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Floats
from planners.path import Path

G = 9.80665


def weave(radius: float, wavelength: float, length: float, spacing: float) -> Path:
    """A path whose curvature is a sine of `wavelength` [m] with a smallest radius of `radius` [m]."""
    fine = np.linspace(0.0, length, 20 * math.ceil(length / spacing) + 1)
    heading = wavelength / (2 * math.pi * radius) * (1.0 - np.cos(2 * math.pi * fine / wavelength))
    step = fine[1]
    x = np.concatenate([[0.0], np.cumsum(np.cos((heading[1:] + heading[:-1]) / 2) * step)])
    y = np.concatenate([[0.0], np.cumsum(np.sin((heading[1:] + heading[:-1]) / 2) * step)])
    return Path(np.column_stack([x, y])[::20])


def aircraft_weave(bank_deg: float = 30.0, length: float = 10_000.0) -> Path:
    """Curves that take a c172x at 55 m/s up to `bank_deg` of bank in still air, a minute each."""
    return weave(55.0**2 / (G * math.tan(math.radians(bank_deg))), 3300.0, length, 20.0)


def road_weave(speed: float, lateral_g: float = 0.5) -> Path:
    """Curves that take a truck at `speed` [m/s] up to `lateral_g`, ten seconds each."""
    return weave(speed**2 / (lateral_g * G), 10.0 * speed, 40.0 * speed, 1.0)


def circle(radius: float, turns: float, spacing: float, run_up: float = 0.0) -> Path:
    """A left-hand circle about (0, radius) after a straight of `run_up` [m]."""
    angle = np.arange(0.0, 2 * math.pi * turns, spacing / radius)
    ring = np.column_stack([radius * np.sin(angle), radius * (1.0 - np.cos(angle))])
    straight: Floats = np.column_stack([np.arange(-run_up, 0.0, spacing), np.zeros(math.ceil(run_up / spacing))])
    return Path(np.concatenate([straight, ring]))


def right_angle(leg: float) -> Path:
    """Two legs of `leg` [m] and a left-hand corner between them."""
    return Path([[0.0, 0.0], [leg, 0.0], [leg, leg]])


def arcs(radius: float, leg: float, corners: int = 4) -> Path:
    """Legs of `leg` [m] joined by quarter circles of `radius` [m], left and right in turn."""
    points, heading = [np.zeros(2)], 0.0

    def forward(distance: float, direction: float) -> None:
        points.append(points[-1] + distance * np.array([math.cos(direction), math.sin(direction)]))

    for corner in range(corners):
        forward(leg, heading)
        turn = (1 if corner % 2 == 0 else -1) * math.pi / 2 / 18
        for _ in range(18):
            forward(2 * radius * math.sin(abs(turn) / 2), heading + turn / 2)
            heading += turn
    forward(leg, heading)
    return Path(np.array(points))
