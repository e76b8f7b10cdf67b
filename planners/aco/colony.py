"""What every colony does: ants set out, those that arrive lay pheromone, and the shortest way so far is kept."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from planners.ground import Ground
from planners.kernel import Bools, Floats
from planners.planner import History, Swarm
from planners.segments import polyline_length


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """The shortest `ways` of the iterations, (N, 2) [cells], each once, the shortest of all first; and the search."""

    ways: tuple[Floats, ...]
    history: History

    @property
    def way(self) -> Floats | None:
        """The shortest of all; None where no ant arrived."""
        return self.ways[0] if self.ways else None


def search(
    ground: Ground,
    ants: int,
    iterations: int,
    send: Callable[[], tuple[Floats, bool]],
    lay: Callable[[Floats, float], None],
    evaporate: Callable[[], None],
) -> Found:
    """Run a colony.

    `send` gives the way (N, 2) [cells] of one ant and whether it arrived, `lay` puts pheromone along a way of that
    length [m], `evaporate` ends the iteration, and only then is what was laid there for others (eq. 2 to 4).
    """
    best, mean, survivors = np.full(iterations, np.nan), np.full(iterations, np.nan), np.zeros(iterations, np.int64)
    swarms, shortest = [], dict[float, Floats]()
    for i in range(iterations):
        ways, lengths, arrived, alive = [], [], [], np.zeros(ants, dtype=bool)
        for ant in range(ants):
            way, alive[ant] = send()
            ways.append(way)
            if not alive[ant]:
                continue
            arrived.append(way)
            lengths.append(polyline_length(way) * ground.cell)
            lay(way, lengths[-1])
        evaporate()
        survivors[i] = len(lengths)
        if lengths:
            best[i], mean[i] = min(lengths), np.mean(lengths)
            shortest.setdefault(min(lengths), arrived[int(np.argmin(lengths))])
        swarms.append(_swarm(ground, ways, alive))
    ordered = tuple(shortest[length] for length in sorted(shortest))
    return Found(ordered, History(best, mean, survivors, ants, tuple(swarms)))


def _swarm(ground: Ground, ways: list[Floats], alive: Bools) -> Swarm:
    first = np.cumsum([0, *(len(way) for way in ways)])
    return Swarm(ground.to_metres(np.concatenate(ways)), first, alive)
