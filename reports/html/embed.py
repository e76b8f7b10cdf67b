"""What is put into the page: data that no name can break out of, and the plotting library."""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
from importlib.util import find_spec
from pathlib import Path

from planners.errors import TrackworthyError
from reports.files.json_result import Json

# A name may hold anything: nothing in it may end the element that it stands in, or begin another.
_ESCAPED = "<>&\u2028\u2029"
_LEVEL = 9


def as_json(data: Json) -> str:
    """`data` as JSON that may stand in a script element, shortest, and without NaN."""
    text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    for character in _ESCAPED:
        text = text.replace(character, f"\\u{ord(character):04x}")
    return text


def plotly() -> str:
    """plotly.js as its Python package brings it, packed: gzip in base64, the same bytes every time."""
    found = find_spec("plotly")  # which imports nothing of it
    if found is None or found.origin is None:
        raise TrackworthyError("plotly is not installed; install trackworthy anew")
    script = (Path(found.origin).parent / "package_data" / "plotly.min.js").read_bytes()
    return base64.b64encode(gzip.compress(script, _LEVEL, mtime=0)).decode()


def nonce(*parts: str) -> str:
    """A word that scripts of the page must know to be run, and that nobody can know who only gives it a name."""
    digest = hashlib.sha256("\0".join(parts).encode("utf-8", "surrogatepass")).digest()
    return base64.b64encode(digest[:18]).decode()


def filled(template: str, parts: dict[str, str]) -> str:
    """`template` with each `{{name}}` replaced once; what is put in is not looked at again."""
    pieces = []
    rest = template
    for name, part in parts.items():
        before, found, rest = rest.partition(f"{{{{{name}}}}}")
        if not found:
            raise KeyError(name)
        pieces += [before, part]
    return "".join([*pieces, rest])
