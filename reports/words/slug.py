"""File names from the names that users give to cases."""

from __future__ import annotations

import re
import unicodedata


def slug(name: str) -> str:
    """`name` as any file system takes it: "Mission 3, 30km/h" is "mission-3-30km-h"."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    return re.sub(r"[^a-z0-9.]+", "-", plain.lower()).strip("-.")[:100] or "case"
