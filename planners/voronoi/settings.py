"""The settings of the Voronoi roadmap."""

from __future__ import annotations

from typing import Annotated

import msgspec


class RoadmapSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Settings of the roadmap; paper 001 gives none.

    candidates: paths tried for each aircraft and target.
    links: roadmap vertices that a start or target is linked to, the nearest in sight.
    sight_spacing: between the points of a path that are joined by line of sight [map units].
    clearance: [m] kept from all that is forbidden; a corridor of the Mars aircraft `ares`.
    """

    candidates: Annotated[int, msgspec.Meta(ge=1, le=1000)] = 3
    links: Annotated[int, msgspec.Meta(ge=1, le=1000)] = 5
    sight_spacing: Annotated[float, msgspec.Meta(gt=0.0, le=1e9)] = 2.0
    clearance: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] = 250.0
