"""The local frame: x east, y north [m], azimuthal equidistant about an origin on a planet's ellipsoid."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from pyproj import Transformer

from planners.kernel import Floats

WGS84_A = 6378137.0  # [m] semi-major axis, NGA.STND.0036 table 3.1
WGS84_B = 6356752.314245  # [m] semi-minor axis, same source
MARS_A = 3396190.0  # [m] equatorial radius of Mars, IAU WGCCRE report 2015 (Archinal et al. 2018), table 4
MARS_B = 3376200.0  # [m] mean polar radius, same source
ELLIPSOIDS = {"earth": (WGS84_A, WGS84_B), "mars": (MARS_A, MARS_B)}
FAITHFUL_RANGE = 200e3  # [m] beyond it, distances across the frame are stretched by more than 0.02 %


@dataclass(frozen=True, slots=True)
class Frame:
    """A local frame about the geodetic position (`lat`, `lon`) [deg] on the ellipsoid with semi-axes `a`, `b` [m]."""

    lat: float
    lon: float
    a: float = WGS84_A
    b: float = WGS84_B

    def to_local(self, lat: Floats, lon: Floats) -> Floats:
        """Geodetic latitudes and longitudes [deg], each (N,), to x, y [m] as (N, 2)."""
        x, y = _transformer(self).transform(np.asarray(lon, dtype=float), np.asarray(lat, dtype=float))
        return np.column_stack([x, y])

    def to_geographic(self, xy: Floats) -> Floats:
        """x, y [m] as (N, 2) to geodetic latitude, longitude [deg] as (N, 2)."""
        lon, lat = _transformer(self).transform(xy[:, 0], xy[:, 1], direction="INVERSE")
        return np.column_stack([lat, lon])


@lru_cache(maxsize=64)
def _transformer(frame: Frame) -> Transformer:
    return Transformer.from_pipeline(
        f"+proj=aeqd +lat_0={frame.lat!r} +lon_0={frame.lon!r} +a={frame.a!r} +b={frame.b!r}"
    )


def true_north(frame: Frame, lat: float, lon: float) -> float:
    """Heading [rad from the frame's x axis] of true north at `lat`, `lon` [deg].

    pi / 2 at the origin and on its meridian; elsewhere meridians converge, by some 2.5 deg 150 km away at 60 deg north.
    """
    step = 1e-4 if lat < 89.0 else -1e-4  # [deg] some 11 m
    here, there = frame.to_local(np.array([lat, lat + step]), np.array([lon, lon]))
    dx, dy = (there - here) / step
    return float(np.arctan2(dy, dx))


def point_transform(frame: Frame) -> Transformer:
    """The raw transformer, `transform(lon, lat) -> (x, y)`, for loops that convert one point at a time."""
    return _transformer(frame)
