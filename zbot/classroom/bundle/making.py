"""Making of a bundle: a folder with all that laptops without the internet need."""

from __future__ import annotations

import contextlib
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.classroom.bundle import installer, manifest
from zbot.classroom.bundle.documents import DOCUMENTS, EXAMPLES, add_documents
from zbot.classroom.bundle.download import PART, fetch, is_whole
from zbot.classroom.bundle.errors import BundleError, file_error
from zbot.classroom.bundle.first_page import FILE as PAGE
from zbot.classroom.bundle.first_page import first_page
from zbot.classroom.bundle.manifest import WHEELS, Manifest, digests
from zbot.classroom.bundle.own_wheel import Source, find_source, own_wheel
from zbot.classroom.bundle.resolver import resolve
from zbot.classroom.bundle.uv_program import NoAnswerError, find_uv
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.classroom.bundle.resolver import Resolution, Wheel
    from zbot.classroom.bundle.target import Target

_INSTALLERS = ("install.sh", "install.ps1", "install.cmd")
_INSTALLER = "install.py"
_AT_ONCE = 3
_SPARE_BYTES = 50_000_000  #: for the documentation and what is written next


@dataclass(frozen=True)
class BundleOptions:
    """Options of a bundle."""

    folder: Path
    targets: list[Target]
    extras: list[str]
    wheel: Path | None = None  #: zbot's own wheel; by default it is built or downloaded


def make_bundle(options: BundleOptions, tell: Callable[[str], None]) -> Manifest:
    """Make a bundle, or complete one. Files that are whole are not fetched again.

    Args:
        options: What the bundle shall contain, and its folder.
        tell: Called with lines about the progress, and about what is left out.

    Raises:
        BundleError: The folder cannot be written, or the package index cannot be reached, or no
            target has wheels.
    """
    find_uv()
    wheels = options.folder.absolute() / WHEELS
    try:
        wheels.mkdir(parents=True, exist_ok=True)
        (wheels / PART).touch()
        (wheels / PART).unlink()
        return _make(options, wheels, tell)
    except OSError as error:
        raise file_error(error.filename or options.folder, error) from error


def _make(options: BundleOptions, wheels: Path, tell: Callable[[str], None]) -> Manifest:
    folder = wheels.parent
    source = find_source()
    own = own_wheel(Source(wheel=options.wheel) if options.wheel else source, wheels, tell)
    found = _resolutions(options, own, tell)
    wanted = {wheel for resolution in found for wheel in resolution.wheels}
    _fetch_missing(wanted, wheels, tell)
    (folder / manifest.FILE).unlink(missing_ok=True)
    _remove_others(wheels, {own.name, *(wheel.name for wheel in wanted)})
    add_documents(source.checkout, folder, tell)
    return _finish(folder, own, found)


def _resolutions(
    options: BundleOptions, own: Path, tell: Callable[[str], None]
) -> list[Resolution]:
    """Find the wheels of all targets. Say what is left out."""

    def resolution(target: Target) -> Resolution | None:
        try:
            return resolve(target, own, options.extras)
        except NoAnswerError as error:
            tell(f"left out: {target}, because {error.reason}")
            return None

    found = []
    with ThreadPoolExecutor(_AT_ONCE) as pool:
        try:
            for number, one in enumerate(pool.map(resolution, options.targets), start=1):
                if one is None:
                    continue
                tell(f"[{number}/{len(options.targets)}] {one.target}: {len(one.wheels)} packages")
                for extra, reason in one.missing.items():
                    tell(f"left out: {extra} for {one.target}, because {reason}")
                found.append(one)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    if not found:
        raise BundleError("there are no wheels for any of the systems and Pythons")
    return found


def _fetch_missing(wanted: set[Wheel], wheels: Path, tell: Callable[[str], None]) -> None:
    missing = {wheel for wheel in wanted if not is_whole(wheels / wheel.name, wheel.sha256)}
    there = f"; {len(wanted) - len(missing)} are here" if len(wanted) > len(missing) else ""
    size = sum(wheel.size for wheel in missing)
    tell(f"{len(wanted)} wheels{there}; {len(missing)} to fetch, {size / 1e6:.0f} MB")
    free = shutil.disk_usage(wheels).free
    if size + _SPARE_BYTES > free:
        raise BundleError(
            f"{wheels.parent} has {free / 1e6:.0f} MB free, and the bundle needs "
            f"{(size + _SPARE_BYTES) / 1e6:.0f} MB more: choose fewer --systems, --python or "
            "--extras, or another folder"
        )
    fetch(missing, wheels, tell)


def _remove_others(wheels: Path, names: set[str]) -> None:
    """Remove wheels of a former bundle, which pip would find, and incomplete files."""
    for path in wheels.iterdir():
        if path.suffix in {".whl", PART} and path.name not in names:
            with contextlib.suppress(OSError):
                path.unlink()


def _finish(folder: Path, own: Path, found: list[Resolution]) -> Manifest:
    """Write the installers, the first page and the manifest."""
    scripts = Path(__file__).parent / "scripts"
    for name in _INSTALLERS:
        shutil.copyfile(scripts / name, folder / name)
    shutil.copyfile(installer.__file__, folder / _INSTALLER)
    files = digests(folder, _names(folder))
    (folder / PAGE).write_text(first_page(__version__, files), encoding="utf-8")
    files |= digests(folder, [PAGE])
    everywhere = [name for name in found[0].extras if all(name in other.extras for other in found)]
    targets = {
        str(one.target): {
            "extras": list(one.extras),
            "wheels": sorted([own.name, *(wheel.name for wheel in one.wheels)]),
        }
        for one in found
    }
    made = Manifest(__version__, everywhere, targets, files)
    made.save(folder)
    return made


def _names(folder: Path) -> list[str]:
    """Return the paths of the files that the bundle consists of."""
    parts = [folder / name for name in (WHEELS, DOCUMENTS, EXAMPLES)]
    inside = [path for part in parts for path in part.rglob("*") if path.is_file()]
    names = [path.relative_to(folder).as_posix() for path in inside]
    return [*names, *_INSTALLERS, _INSTALLER]
