"""Names of any length in the room there is for them."""

from __future__ import annotations

from matplotlib.text import Text

_SHORTEST = 8  # characters


def shortened(name: str, most: int) -> str:
    """`name` on one line, cut in the middle where it has more than `most` characters: both its ends tell."""
    name = " ".join(name.split())
    if len(name) <= most:
        return name
    head = most // 2
    return f"{name[:head]}…{name[len(name) - (most - head - 1) :]}"


def fit(text: Text, room: float, smallest: float | None = None) -> None:
    """Make `text` no wider than `room` [pixels]: in smaller type down to `smallest` [pt], then cut in the middle."""
    width = text.get_window_extent().width
    if width <= room:
        return
    if smallest is not None:
        size = float(text.get_fontsize())
        text.set_fontsize(max(smallest, size * room / width))
    name, width = text.get_text(), text.get_window_extent().width
    kept = len(name)
    while width > room and kept > _SHORTEST:
        kept = max(_SHORTEST, min(kept - 1, int(kept * room / width)))
        text.set_text(shortened(name, kept))
        width = text.get_window_extent().width
