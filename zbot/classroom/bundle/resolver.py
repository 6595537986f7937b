"""Resolver: finds the wheels that a target needs, without running Python of the target."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any
from urllib.parse import unquote, urlsplit

from zbot.classroom.bundle.errors import BundleError
from zbot.classroom.bundle.target import environment
from zbot.classroom.bundle.uv_program import NoAnswerError, run_uv

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.classroom.bundle.target import Target


@dataclass(frozen=True)
class Wheel:
    """A wheel of a package index."""

    name: str  #: of the file
    url: str
    sha256: str
    size: int  #: in bytes, 0 if the index does not say it


@dataclass(frozen=True)
class Resolution:
    """What a target gets."""

    target: Target
    extras: tuple[str, ...]
    wheels: tuple[Wheel, ...]
    missing: dict[str, str]  #: the reason for each extra that has no wheels for the target


def resolve(target: Target, own_wheel: Path, extras: list[str]) -> Resolution:
    """Find the wheels of zbot's dependencies for a target. Leave out extras that have none.

    Args:
        target: The target.
        own_wheel: zbot's own wheel.
        extras: The wanted extras.

    Raises:
        NoAnswerError: zbot itself has no wheels for the target.
        BundleError: The package index cannot be reached.
    """
    missing: dict[str, str] = {}
    try:
        found = _wheels(target, own_wheel, extras)
    except NoAnswerError as error:
        if not extras:
            raise
        missing = _extras_without_wheels(target, own_wheel, extras)
        if not missing:  # each fits alone, but not all together
            missing = {extras[-1]: error.reason}
        rest = resolve(target, own_wheel, [name for name in extras if name not in missing])
        return Resolution(target, rest.extras, rest.wheels, {**missing, **rest.missing})
    return Resolution(target, tuple(extras), found, missing)


def _extras_without_wheels(target: Target, own_wheel: Path, extras: list[str]) -> dict[str, str]:
    missing = {}
    for extra in extras:
        try:
            _wheels(target, own_wheel, [extra])
        except NoAnswerError as error:
            missing[extra] = error.reason
    return missing


def _wheels(target: Target, own_wheel: Path, extras: list[str]) -> tuple[Wheel, ...]:
    packages = locked(
        f"zbot[{','.join(extras)}] @ {own_wheel.as_uri()}\npip\n",
        *("--python-platform", target.platform, "--python-version", target.python),
        variables=environment(),
    )
    return tuple(_best(package, target) for package in packages if package["name"] != "zbot")


def locked(
    requirements: str, *words: str, variables: dict[str, str] | None = None
) -> list[dict[str, Any]]:
    """Return the packages that fit requirements, as a lock file of Python lists them.

    Args:
        requirements: A requirement in each line.
        words: Options of `uv pip compile`.
        variables: Environment variables for uv.
    """
    text = run_uv(
        *("pip", "compile", "-", "--quiet", "--no-header", "--format", "pylock.toml"),
        *(
            "--only-binary",
            ":all:",
            "--python",
            sys.executable,
            *words,
        ),  # else uv tries all Pythons
        text=requirements,
        variables=variables,
    )
    packages: list[dict[str, Any]] = tomllib.loads(text).get("packages", [])
    return packages


def _best(package: dict[str, Any], target: Target) -> Wheel:
    """Return the wheel of a package that fits best."""
    from packaging.utils import parse_wheel_filename  # noqa: PLC0415 - an extra

    ranks = {tag: rank for rank, tag in enumerate(target.tags())}
    found: list[tuple[int, Wheel]] = []
    for entry in package.get("wheels", []):
        wheel = wheel_of(entry)
        fitting = [ranks[tag] for tag in parse_wheel_filename(wheel.name)[3] if tag in ranks]
        if fitting:
            found.append((min(fitting), wheel))
    if not found:
        raise BundleError(f"{package['name']} has no wheel for {target}")
    return min(found, key=lambda ranked: ranked[0])[1]


def wheel_of(entry: dict[str, Any]) -> Wheel:
    """Return the wheel in an entry of a lock file."""
    url = entry.get("url") or entry["path"]
    name = entry.get("name") or unquote(urlsplit(url).path.rpartition("/")[2])
    return Wheel(name, url, entry["hashes"]["sha256"], entry.get("size", 0))
