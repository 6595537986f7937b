"""zbot's own wheel, and the folder from which it was made."""

from __future__ import annotations

import re
import shutil
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlsplit
from urllib.request import url2pathname

from zbot.classroom.bundle.download import fetch
from zbot.classroom.bundle.errors import BundleError, file_error
from zbot.classroom.bundle.resolver import locked, wheel_of
from zbot.classroom.bundle.uv_program import NoAnswerError, run_uv
from zbot.text.json_reader import JsonError, read_json_object
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Callable


@dataclass(frozen=True)
class Source:
    """Where the wheel of this zbot comes from."""

    checkout: Path | None = None  #: folder with `pyproject.toml`
    wheel: Path | None = None  #: file from which this zbot was installed


def find_source() -> Source:
    """Return the checkout or the wheel from which this zbot was installed, if it is still there."""
    checkout = Path(__file__).parents[3]
    if _is_checkout(checkout):
        return Source(checkout)
    place = _installed_from()
    if place is None:
        return Source()
    if _is_checkout(place):
        return Source(place)
    return Source(wheel=place if place.suffix == ".whl" and place.is_file() else None)


def _is_checkout(folder: Path) -> bool:
    """Return whether a folder has the source of this version."""
    try:
        version = (folder / "zbot" / "version.py").read_text("utf-8")
    except OSError:
        return False
    return (folder / "pyproject.toml").is_file() and f'"{__version__}"' in version


def _installed_from() -> Path | None:
    """Return the folder or file that pip noted when it installed zbot."""
    try:
        text = distribution("zbot").read_text("direct_url.json")
        url = str(read_json_object(text)["url"]) if text else ""
    except (PackageNotFoundError, JsonError, KeyError):
        return None
    parts = urlsplit(url)
    return Path(url2pathname(parts.path)) if parts.scheme == "file" else None


def own_wheel(source: Source, folder: Path, tell: Callable[[str], None]) -> Path:
    """Put zbot's own wheel into a folder, and say where it is from.

    Raises:
        BundleError: The wheel cannot be built or found.
    """
    try:
        if source.checkout:
            found = _build(source.checkout, folder)
            tell(f"zbot {__version__}: built from {source.checkout}")
        elif source.wheel:
            found = Path(shutil.copy(source.wheel, folder))
            tell(f"zbot {__version__}: a copy of {source.wheel}")
        else:
            found = _download(folder)
            tell(f"zbot {__version__}: downloaded from the package index")
    except OSError as error:
        raise file_error(error.filename or folder, error) from error
    if not re.match(r"zbot-[^-]+-py3-none-any\.whl$", found.name):
        raise BundleError(f"{found} is not a wheel of zbot")
    return found


def _build(checkout: Path, folder: Path) -> Path:
    work = folder / "own"
    shutil.rmtree(work, ignore_errors=True)
    run_uv("build", "--wheel", "--quiet", "--out-dir", str(work), str(checkout))
    built = next(work.glob("zbot-*.whl"))
    path = folder / built.name
    built.replace(path)
    shutil.rmtree(work)
    return path


def _download(folder: Path) -> Path:
    try:
        package = next(iter(locked(f"zbot=={__version__}\n", "--no-deps")))
    except NoAnswerError:
        raise BundleError(
            f"the package index has no zbot {__version__}, and this zbot was not installed from a "
            "folder or file that is still there: type the command in a checkout, or give --wheel"
        ) from None
    wheel = wheel_of(package["wheels"][0])
    fetch([wheel], folder, lambda _: None)
    return folder / wheel.name
