"""What made a folder of results: versions, hashes, seeds; and whether it is the same that would go on."""

from __future__ import annotations

import platform
import shlex
import shutil
import subprocess
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import msgspec

from campaigns.campaign import Campaign
from campaigns.ready import ReadyCase
from campaigns.search_ready import ReadySearch
from campaigns.seeds import digest, file_digest
from planners.atomic_file import atomic
from planners.errors import InputError
from tracking.metric import SCHEMA_VERSION

STORE_VERSION = 1  # of the folder's layout and its tables
# Packages that decide results
DECIDING = ("jsbsim", "highway-env", "numpy", "scipy", "numba", "shapely", "pyproj", "scikit-image", "pillow", "piqp")
OWN = ("planners", "sim", "tracking", "campaigns")
HOME = Path(__file__).parents[1]


class Manifest(msgspec.Struct, frozen=True):
    """`campaign` is the hash of all that decides the results but the code, `code` that of the code; `called` is the
    campaign as it was given to the command line, `only` the cases that were named there, `notes` are those on cases.
    """

    name: str
    store_version: int
    schema_version: int
    campaign: str
    code: str
    versions: dict[str, str]
    git_revision: str
    platform: str
    seed: int
    cases: dict[str, str]
    called: str = ""
    only: tuple[str, ...] = ()
    notes: dict[str, tuple[str, ...]] = {}

    @property
    def command(self) -> str:
        """The command that made the results; "" where it is not known."""
        cases = [word for name in self.only for word in ("--case", name)]
        return shlex.join(["trackworthy", "run", self.called, *cases]) if self.called else ""


def manifest_of(campaign: Campaign, cases: Sequence[ReadyCase], searches: Sequence[ReadySearch] = ()) -> Manifest:
    """What would make the results of `campaign` now."""
    # Of a plan for each trial the first tells the others, and more trials make no other case
    digests = {ready.case.name: digest(ready.digest, ready.plans[0].key if ready.plans else "") for ready in cases}
    digests |= {f"{ready.search.BLOCK} {ready.search.name}": ready.key for ready in searches}
    return Manifest(
        name=campaign.name,
        store_version=STORE_VERSION,
        schema_version=SCHEMA_VERSION,
        campaign=digest(campaign.seed, campaign.keep_tracks, list(digests.items())),
        code=fingerprint(),
        versions={"python": platform.python_version(), **_versions()},
        git_revision=_git_revision(),
        platform=platform.platform(),
        seed=campaign.seed,
        cases=digests,
        called=campaign.file,
        only=campaign.only,
        notes={ready.case.name: ready.notes for ready in cases if ready.notes and not ready.plans},
    )


def check_same(found: Manifest, wanted: Manifest, folder: Path) -> None:
    """Raises `InputError` with the remedy unless results of `found` and of `wanted` may lie in one folder."""
    remedy = "give another folder with -o, or start anew with --fresh"
    if found.name != wanted.name:
        raise InputError(str(folder), f"holds the results of another campaign, {found.name!r}", remedy)
    if (found.store_version, found.schema_version) != (wanted.store_version, wanted.schema_version):
        what = f"schema {found.store_version}.{found.schema_version}"
        raise InputError(str(folder), f"its results have {what}, these {STORE_VERSION}.{SCHEMA_VERSION}", remedy)
    if found.campaign != wanted.campaign:
        raise InputError(str(folder), f"the campaign or its files have changed: {_change(found, wanted)}", remedy)
    if found.code != wanted.code:
        raise InputError(str(folder), "its results are of another version of trackworthy or its libraries", remedy)


def _change(found: Manifest, wanted: Manifest) -> str:
    """What tells two campaigns apart, as far as it is a case."""
    if found.seed != wanted.seed:
        return "its seed"
    for name, digest_now in wanted.cases.items():
        if name not in found.cases:
            return f"{name!r} is a new case"
        if found.cases[name] != digest_now:
            return f"{name!r} is not the same"
    if gone := next((name for name in found.cases if name not in wanted.cases), None):
        return f"{gone!r} is not among the cases now"
    return "its keep_tracks"


def read_manifest(file: Path) -> Manifest | None:
    """The manifest of a folder of results, None where there is none; raises `InputError` for one that is damaged."""
    try:
        return msgspec.json.decode(file.read_bytes(), type=Manifest)
    except FileNotFoundError:
        return None
    except (OSError, msgspec.DecodeError) as error:
        what = f"is damaged, or of another version ({error})"
        remedy = "run the campaign anew with --fresh, or into another folder with -o"
        raise InputError(str(file), what, remedy) from None


def write_manifest(manifest: Manifest, file: Path) -> None:
    """Store it as JSON."""
    with atomic(file) as temporary:
        temporary.write_bytes(msgspec.json.format(msgspec.json.encode(manifest), indent=2) + b"\n")


def fingerprint() -> str:
    """A hash of the code and the libraries that decide results."""
    files = [file for folder in OWN for file in sorted((HOME / folder).rglob("*")) if file.suffix in (".py", ".xml")]
    contents = [(file.relative_to(HOME).as_posix(), file_digest(file)) for file in files]
    return digest(contents, _versions())


def _versions() -> dict[str, str]:
    return {package: _version(package) for package in ("trackworthy", *DECIDING)}


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "unknown"


def _git_revision() -> str:
    """The revision of the checkout that runs, with a "+" where it has changes; "" where it is none."""
    if not (HOME / ".git").exists() or shutil.which("git") is None:
        return ""

    def git(*words: str) -> str:
        command = ["git", "-C", str(HOME), *words]
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()

    return git("rev-parse", "HEAD") + ("+" if git("status", "--porcelain", "--untracked-files=no") else "")
