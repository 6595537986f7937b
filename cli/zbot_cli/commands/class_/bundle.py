"""Lines of `zbot class bundle`, and those of `zbot class start --bundle`."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, metadata
from typing import TYPE_CHECKING

from zbot.classroom.bundle import manifest
from zbot.classroom.bundle.making import BundleOptions, make_bundle
from zbot.classroom.bundle.target import parse_extras, parse_targets

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.classroom.bundle.service import Served

_OWN_EXTRAS = {"dev", "docs", "test"}  #: for those who work on zbot


def make(folder: Path, systems: str, pythons: str, extras: str, wheel: Path | None) -> None:
    """Make a bundle, and print the progress."""
    targets = parse_targets(systems, pythons)
    wanted = parse_extras(extras, _known_extras())
    made = make_bundle(BundleOptions(folder, targets, wanted, wheel), _tell)
    print(f"{folder} is ready: zbot {made.version}, {_size(folder, made)}")
    print(f"A student opens {folder / 'index.html'}, or you serve it:")
    print(f"    zbot class start --bundle {folder}")


def check(folder: Path) -> None:
    """Check each file of a bundle.

    Raises:
        BundleError: A file is missing or damaged.
    """
    made = manifest.load(folder)
    made.check(folder)
    print(f"{folder} is whole: zbot {made.version}, {_size(folder, made)}")


def lines(served: Served) -> list[str]:
    """Return what students without zbot type."""
    return [
        "Students without zbot install it. On Windows, they type:",
        "",
        f"    py {served.words}",
        "",
        "and on macOS and Linux:",
        "",
        f"    python3 {served.words}",
        "",
        "If pip says `externally-managed-environment`, they make an environment first:",
        "",
        "    python3 -m venv zbot-env && . zbot-env/bin/activate",
        "",
        f"Documentation: {served.address}",
        "",
    ]


def _known_extras() -> list[str]:
    try:
        found = metadata("zbot").get_all("Provides-Extra") or []
    except PackageNotFoundError:
        return []
    return sorted(set(found) - _OWN_EXTRAS)


def _size(folder: Path, made: manifest.Manifest) -> str:
    size = sum((folder / name).stat().st_size for name in made.files) / 1e6
    return f"{len(made.targets)} systems and Pythons, {len(made.files)} files, {size:.0f} MB"


def _tell(line: str) -> None:
    print(line, flush=True)
