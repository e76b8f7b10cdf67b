"""The pictures of a campaign's plans: the first of each planner, planned again."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from campaigns.plan_statistics import PlannedBy
from planners.astar.arc_printed import AstarArcPaper
from planners.astar.settings import planned_speed
from planners.facts import PlanFacts
from planners.planner import NO_PATH, History, Plan
from reports.figures.colony_figure import colony_figure, shown_iterations
from reports.figures.comparison_figure import comparison_figure
from reports.figures.convergence_figure import HIGHEST, LOW, convergence_figure
from reports.figures.drawing import Drawing
from reports.figures.plan_figure import plans_figure
from reports.figures.plan_turn import came
from reports.figures.roadmap_figure import has_roadmap, roadmap_figure
from reports.figures.routes_figure import COLUMNS as SPEEDS
from reports.figures.routes_figure import ROWS, Route, routes_figure
from reports.figures.sector_figure import COLUMNS, sector_figure
from reports.pages.plan_rows import is_fleet
from reports.words.quantity import number
from reports.words.slug import slug
from reports.words.words import KMH

_EARLY = (1, 3, 5, 10)  # iterations shown of a search of no more


def plan_drawings(plans: Mapping[str, PlannedBy], planned: Mapping[str, Plan], stem: str) -> list[Drawing]:
    """The pictures of `plans` of one scenario, by label; their names begin with `stem`. `planned` are the plans.

    The roadmap, the sectors of A* by arcs, the searches in the same axes, the routes where planners plan for speeds,
    each other planner's plan, and each one's ants. The same plans give the same bytes.
    """
    searches = {name: plan.history for name, plan in planned.items() if plan.history is not None}
    colonies = {name: history for name, history in searches.items() if history.evaluations is None}
    counted = {name: one.searches for name, one in plans.items() if len(one.searches) > 1}
    routes = _routes(plans, planned)
    return [
        *_draw_roadmap(plans, planned, stem),
        *_draw_sectors(plans, planned, stem),
        *_draw_convergence(plans, counted, stem),
        *_draw_comparison(plans, colonies, stem),
        *_draw_routes(plans, {name: planned[name] for name in routes}, stem),
        *(_draw_plan(name, plans[name], plan, stem) for name, plan in planned.items() if name not in routes),
        *(_draw_ants(name, plans[name], history, stem) for name, history in searches.items() if history.swarms),
    ]


def chosen_iterations(history: History) -> tuple[int, ...]:
    """Those shown of a search: of a long one the first, the first in which one arrives, the first near the best, and
    the last; where these are fewer than four, a spread.
    """
    count = len(history.swarms)
    if count <= max(_EARLY):
        return shown_iterations(count, _EARLY)
    arrived = [i for i, alive in enumerate(history.survivors, start=1) if alive]
    marked = shown_iterations(count, [1, *arrived[:1], history.converged or 1, count])
    return marked if len(marked) == len(_EARLY) else shown_iterations(count)


def _draw_plan(name: str, one: PlannedBy, plan: Plan, stem: str) -> Drawing:
    shown = (one.scenario, {name: plan}, one.planner.clearance, planned_speed(one.planner))
    caption = _plan_caption(name, one, plan) + _beside(claim.beside.plan for claim in one.claims)
    return Drawing(_file(stem, name), plans_figure, shown, caption)


def _routes(plans: Mapping[str, PlannedBy], planned: Mapping[str, Plan]) -> list[str]:
    """Those shown side by side, where several are and some plan for a speed: all that are driven, but for searches
    that have a picture of how they went on.
    """
    driven = [
        name for name, plan in planned.items()
        if plans[name].driven_at is not None and plan.history is None and not is_fleet(plans[name].scenario)
    ]  # fmt: skip
    return driven if len(driven) > 1 and any(plans[name].planned_for for name in driven) else []


def _draw_routes(plans: Mapping[str, PlannedBy], routes: Mapping[str, Plan], stem: str) -> list[Drawing]:
    """First those for no speed, then a row of each planner that plans for speeds."""
    kinds: dict[str, list[str]] = {}
    for name in sorted(routes, key=lambda name: plans[name].planned_for is not None):
        kinds.setdefault(plans[name].planner.name if plans[name].planned_for else "", []).append(name)
    rows = [names[i : i + SPEEDS] for names in kinds.values() for i in range(0, len(names), SPEEDS)]
    pages = [rows[i : i + ROWS] for i in range(0, len(rows), ROWS)]
    pictures = []
    for page_number, page in enumerate(pages, start=1):
        file = _file(stem, f"routes {page_number}" if len(pages) > 1 else "routes")
        shown = [[_route(name, plans[name], routes[name]) for name in row] for row in page]
        beside = _beside(claim.beside.plan for row in page for name in row for claim in plans[name].claims)
        who = _listed(dict.fromkeys(plans[name].planner.name for row in page for name in row))
        unplanned = any(plans[name].planned_for is None for row in page for name in row)
        slowest = ", or the slowest at which it is driven" if unplanned else ""
        what = f"the routes, and the most lateral acceleration that each needs at the speed it is planned for{slowest}."
        pictures.append(Drawing(file, routes_figure, (plans[page[0][0]].scenario, shown), f"{who}: {what}{beside}"))
    return pictures


def _route(name: str, one: PlannedBy, plan: Plan) -> Route:
    speed = one.driven_at or 0.0
    return Route(name if one.planned_for else f"{name}, {number(KMH * speed)} km/h", plan, speed)


def _draw_ants(name: str, one: PlannedBy, history: History, stem: str) -> Drawing:
    shown = chosen_iterations(history)
    caption = _ants_caption(name, history, shown) + _beside(claim.beside.ants for claim in one.claims)
    return Drawing(_file(stem, f"{name} ants"), colony_figure, (one.scenario, history, shown), caption)


def _draw_comparison(plans: Mapping[str, PlannedBy], searches: Mapping[str, History], stem: str) -> list[Drawing]:
    if len(searches) < 2:
        return []
    exact = [one.statistics.exact_length for one in plans.values() if one.statistics.exact_length is not None]
    what = "length of the best way and of the mean one, and share of ants that arrive, by iteration."
    beside = _beside(claim.beside.comparison for name in searches for claim in plans[name].claims)
    caption = f"{_listed(searches)} on the same axes: {what}{beside}"
    return [Drawing(_file(stem, "comparison"), comparison_figure, (dict(searches), max(exact, default=None)), caption)]


def _draw_convergence(
    plans: Mapping[str, PlannedBy], searches: Mapping[str, Sequence[PlanFacts]], stem: str
) -> list[Drawing]:
    if not searches:
        return []
    known = [plans[name].statistics.exact_length for name in searches]
    exact = max((one for one in known if one is not None), default=None)
    seeds = " and ".join(dict.fromkeys(str(len(facts)) for facts in searches.values()))
    what = f"the best sum of paths within all limits by cost evaluations, median and band of {number(LOW)} to"
    band = f"{number(HIGHEST)} % over {seeds} seeds; and the share of seeds that have such paths."
    beside = _beside(claim.beside.comparison for name in searches for claim in plans[name].claims)
    caption = f"{_listed(searches)}: {what} {band}{beside}"
    return [Drawing(_file(stem, "convergence"), convergence_figure, (dict(searches), exact), caption)]


def _draw_roadmap(plans: Mapping[str, PlannedBy], planned: Mapping[str, Plan], stem: str) -> list[Drawing]:
    """That of the plan with the most steps, the shortest of these: the others share its roadmap."""
    found = {name: plan for name, plan in planned.items() if has_roadmap(plan)}
    if not found:
        return []
    name = max(found, key=lambda one: (len(found[one].stages), -sum(path.length for path in found[one].paths)))
    one = plans[name]
    steps = _listed([f"the {found[name].stages[0].name}", *(stage.name for stage in found[name].stages[1:])])
    beside = _beside(claim.beside.roadmap for other in plans.values() for claim in other.claims)
    caption = f"The Voronoi roadmap, and the paths of {name} after {steps}.{beside}"
    shown = (one.scenario, found[name], one.planner.clearance)
    return [Drawing(_file(stem, "roadmap"), roadmap_figure, shown, caption)]


def _draw_sectors(plans: Mapping[str, PlannedBy], planned: Mapping[str, Plan], stem: str) -> list[Drawing]:
    """Of A* by arcs, as printed, the first three that had a map to search."""
    searched = {name: plans[name].planner for name, plan in planned.items() if plan.outcome != NO_PATH}
    arcs = {name: planner for name, planner in searched.items() if isinstance(planner, AstarArcPaper)}
    names = list(arcs)[:COLUMNS]
    if not names:
        return []
    shown = (plans[names[0]].scenario, {name: arcs[name] for name in names})
    what = "above, of its sectors the one that an obstacle cuts most and leaves a way on; below, where it ended."
    beside = _beside(claim.beside.sectors for name in names for claim in plans[name].claims)
    return [Drawing(_file(stem, "sectors"), sector_figure, shown, f"{_listed(names)}: {what}{beside}")]


def _plan_caption(name: str, one: PlannedBy, plan: Plan) -> str:
    if not plan.paths:
        stuck = ", dashed as far as it came" if came(plan) else ""
        return f"{name}, seed {one.seed}: {plan.outcome}{stuck}."
    if len(plan.paths) > 1:
        before = [f"dashed, those after {plan.stages[-2].name}"] if len(plan.stages) > 1 else []
        parts = ["the paths", *before, "the sharpest turn from near"]
        parts += ["the best sum by iteration"] if plan.history is not None else []
        return f"{name}, seed {one.seed}: {', '.join(parts)}; thin, the exact shortest paths."
    parts = ["the path", *(["before smoothing dashed"] if plan.smallest_radius is not None and plan.polylines else [])]
    parts += [f"its {'sharpest turn' if plan.smallest_radius is None else 'tightest curve'} from near"]
    if plan.history is not None:
        parts.append("length of the best way and of the mean one of each iteration, and how many arrive")
    speed = planned_speed(one.planner)
    much = "" if speed is None else f" Where it asks too much at {number(KMH * speed)} km/h, it is red."
    return f"{name}, seed {one.seed}: {', '.join(parts)}; thin, the exact shortest path.{much}"


def _ants_caption(name: str, history: History, shown: Sequence[int]) -> str:
    told = [f"{history.survivors[i - 1]} in iteration {i}" for i in shown]
    return f"{name}: the ways of all {history.population} ants; of them arrive {_listed(told)}."


def _beside(figures: Iterable[str]) -> str:
    """The source's own figures that it stands beside."""
    named = dict.fromkeys(filter(None, figures))
    return f" Beside {'; '.join(named)}." if named else ""


def _listed(names: Iterable[str]) -> str:
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last


def _file(stem: str, what: str) -> str:
    return f"{stem}-{slug(what)}"
