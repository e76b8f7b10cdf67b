"""The report as one HTML file that needs no network: what the PDF tells, and a replay of every case."""

from __future__ import annotations

from pathlib import Path

from campaigns.finished import Finished
from planners.atomic_file import atomic
from reports.files.json_result import Json
from reports.html.absent import absent
from reports.html.case_rows import case_rows
from reports.html.embed import as_json, filled, nonce, plotly
from reports.html.pictures import embedded
from reports.html.runs import add_others, worst_runs
from reports.html.spread import spread_data
from reports.html.world import World

LIMIT = 7_900_000  # bytes of the file, about: below 8 MB
_WORST, _PICTURES = 0.45, 0.5  # shares of what is left: of the worst runs, and then of the pictures
_HERE = Path(__file__).parent
_SCRIPTS = (
    "page", "numbers", "overview", "matrix", "cases", "case_tables", "plots", "spread", "map", "body",
    "attitude", "replay", "case", "plans", "scenarios", "check", "appendix", "start",
)  # fmt: skip


def write_html(finished: Finished, data: dict[str, Json], file: Path, limit: int = LIMIT) -> None:
    """Write the page on a `finished` campaign: the same results give the same bytes.

    `data` is what the report tells in words and tables; the pictures that it names lie in the folder's `figures`.
    Tracks and pictures are left out, and counted on the page, where they would make the file larger than `limit` bytes.
    The file appears whole or not at all. Raises `InputError` where its folder does not exist.
    """
    library = plotly()
    content = as_json(_content(finished, data, limit - len(library)))
    style = (_HERE / "report.css").read_text("utf-8")
    script = "\n".join((_HERE / "js" / f"{name}.js").read_text("utf-8") for name in _SCRIPTS)
    key = nonce(content, script)
    parts = {"nonce": key, "style": style, "data": content, "plotly": library, "key": key, "script": script}
    page = filled((_HERE / "report.html").read_text("utf-8"), parts)
    with atomic(file) as temporary:
        temporary.write_bytes(page.encode("utf-8", "replace"))


def _content(finished: Finished, data: dict[str, Json], room: int) -> dict[str, Json]:
    """All that the page shows, in about `room` bytes: the worst runs first, then pictures, then other trials."""
    world = World()
    spread: dict[str, Json] = {
        name: spread_data(result, finished.outcomes[name])
        for result in finished.results
        if (name := result.case.name) in finished.outcomes
    }
    fixed: dict[str, Json] = {
        "spread": spread,
        "rows": case_rows(finished),
        "about": _about(finished),
        "absent": absent(finished),
    }
    room -= len(as_json({**fixed, "told": data}).encode())
    cases = worst_runs(finished, world, int(_WORST * room))
    room -= len(as_json({"cases": {**cases}, "maps": world.maps, "paths": world.paths}))
    # The plans of a scenario are those of all plans
    told, left = embedded(_without_plans(data), finished.folder / "figures", int(_PICTURES * room))
    add_others(finished, cases, world, room - int(_PICTURES * room) + left)
    return {**fixed, "told": told, "maps": world.maps, "paths": world.paths, "cases": {**cases}}


def _without_plans(data: dict[str, Json]) -> dict[str, Json]:
    scenarios = data.get("scenarios")
    if not isinstance(scenarios, list):
        return data
    return {**data, "scenarios": [{**one, "plans": None} for one in scenarios if isinstance(one, dict)]}


def _about(finished: Finished) -> Json:
    return {"note": finished.campaign.note, "version": finished.manifest.versions.get("trackworthy", "")}
