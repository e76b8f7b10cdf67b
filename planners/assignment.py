"""Who flies where: one candidate path an aircraft and a target, chosen as a knapsack problem and solved exactly."""

from __future__ import annotations

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import csr_array

from planners.errors import TrackworthyError
from planners.kernel import Bools, Floats, Ints


def assigned(aircraft: Ints, targets: Ints, lengths: Floats, allowed: Bools) -> Ints:
    """Indices of the candidates (N,) that are flown, in the order of their aircraft.

    Candidate i leads `aircraft[i]` to `targets[i]` in `lengths[i]`, any unit. Each aircraft flies at most one, each
    target is flown to at most once, and only candidates that are `allowed` are. As many pairs as possible are served,
    and of those choices the one of least total length is taken. This is the multi-dimensional multiple-choice knapsack
    problem of paper 001, section 2.1, in which range and turn limits (eq. 3, 4) bound a path by itself; by HiGHS.
    """
    kept = np.flatnonzero(allowed)
    if not len(kept):
        return kept
    rows = np.concatenate([aircraft[kept], aircraft.max() + 1 + targets[kept]])
    columns = np.tile(np.arange(len(kept)), 2)
    once = LinearConstraint(csr_array((np.ones(len(rows)), (rows, columns))), -np.inf, 1.0)
    # One pair more is worth more than any lengths: these are at most 1 each
    most = min(len(np.unique(aircraft[kept])), len(np.unique(targets[kept])))
    cost = lengths[kept] / lengths[kept].max() - (most + 1.0)
    whole = np.ones(len(kept))
    found = milp(cost, constraints=once, bounds=Bounds(0.0, 1.0), integrality=whole, options={"mip_rel_gap": 0.0})
    if found.x is None:
        raise TrackworthyError(f"assignment: HiGHS says {found.message!r}")
    chosen = kept[found.x > 0.5]
    return np.asarray(chosen[np.argsort(aircraft[chosen])], dtype=np.int64)
