"""Target of a bundle: a system, a processor and a version of Python."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.classroom.bundle.errors import BundleError
from zbot.errors.suggestion import did_you_mean

if TYPE_CHECKING:
    from collections.abc import Iterator

    from packaging.tags import Tag

PYTHONS = ("3.10", "3.11", "3.12", "3.13", "3.14")
_MACOS = (11, 0)  #: the oldest macOS on which wheels must run
_GLIBC = (2, 28)  #: the oldest C library: Debian 10, Ubuntu 20.04, Raspberry Pi OS 10
_OLDEST_GLIBC = (2, 17)

#: Names of platforms for uv, by system and processor.
PLATFORMS = {
    "windows-x86_64": "x86_64-pc-windows-msvc",
    "macos-arm64": "aarch64-apple-darwin",
    "macos-x86_64": "x86_64-apple-darwin",
    "linux-x86_64": "x86_64-manylinux_2_28",
    "linux-aarch64": "aarch64-manylinux_2_28",
}
_LEGACY = {(2, 17): "manylinux2014"}


@dataclass(frozen=True)
class Target:
    """A kind of laptop that installs from a bundle."""

    machine: str  #: a key of `PLATFORMS`
    python: str  #: e.g. `3.13`

    def __str__(self) -> str:
        return f"{self.machine}-{self.python}"

    @property
    def platform(self) -> str:
        """The name of the platform for uv."""
        return PLATFORMS[self.machine]

    def tags(self) -> list[Tag]:
        """Return the tags of the wheels that fit, the best first."""
        from packaging.tags import compatible_tags, cpython_tags  # noqa: PLC0415 - an extra

        version = tuple(map(int, self.python.split(".")))
        name = f"cp{self.python.replace('.', '')}"
        platforms = list(self._platform_tags())
        found = list(cpython_tags(version, [name], platforms))
        return [*found, *compatible_tags(version, name, platforms)]

    def _platform_tags(self) -> Iterator[str]:
        from packaging.tags import mac_platforms  # noqa: PLC0415 - an extra

        system, _, processor = self.machine.partition("-")
        if system == "windows":
            yield "win_amd64"
        elif system == "macos":
            yield from mac_platforms(_MACOS, processor)
        else:
            for minor in range(_GLIBC[1], _OLDEST_GLIBC[1] - 1, -1):
                yield f"manylinux_2_{minor}_{processor}"
                if (2, minor) in _LEGACY:
                    yield f"{_LEGACY[2, minor]}_{processor}"
            if processor == "x86_64":
                yield from ("manylinux2010_x86_64", "manylinux1_x86_64")
            yield f"linux_{processor}"


def environment() -> dict[str, str]:
    """Return the variables with which uv knows the oldest macOS."""
    return {"MACOSX_DEPLOYMENT_TARGET": ".".join(map(str, _MACOS))}


def parse_targets(systems: str, pythons: str) -> list[Target]:
    """Return the targets in the options of a command.

    Args:
        systems: Names with commas, e.g. `windows,linux` or `linux-x86_64`.
        pythons: Versions with commas, e.g. `3.12,3.13`, or the first and the last: `3.11..3.14`.

    Raises:
        BundleError: A name or version is unknown.
    """
    machines = [machine for name in _words(systems) for machine in _machines(name)]
    versions = [version for text in _words(pythons) for version in _versions(text)]
    if not machines or not versions:
        raise BundleError("a bundle needs a system and a Python, e.g. `windows` and `3.13`")
    return [
        Target(machine, version)
        for machine in dict.fromkeys(machines)
        for version in dict.fromkeys(versions)
    ]


def parse_extras(text: str, known: list[str]) -> list[str]:
    """Return the extras in an option, e.g. `web,bag`.

    Args:
        text: Names with commas. An empty text means no extra.
        known: The extras of zbot.

    Raises:
        BundleError: zbot has no such extra.
    """
    names = list(dict.fromkeys(_words(text)))
    for name in names:
        if name not in known:
            advice = did_you_mean(name, known) or f"the extras are {', '.join(known)}"
            raise BundleError(f"zbot has no extra {name!r}; {advice}")
    return names


def _words(text: str) -> list[str]:
    return [word.strip().lower() for word in text.split(",") if word.strip()]


def _machines(name: str) -> list[str]:
    found = [machine for machine in PLATFORMS if name in {machine, machine.partition("-")[0]}]
    if not found:
        systems = list(dict.fromkeys(machine.partition("-")[0] for machine in PLATFORMS))
        advice = did_you_mean(name, systems) or f"write {', '.join(systems)}, or one of {_ALL}"
        raise BundleError(f"unknown system {name!r}; {advice}")
    return found


_ALL = ", ".join(PLATFORMS)


def _versions(text: str) -> list[str]:
    first, dots, last = text.partition("..")
    for version in (first, last) if dots else (first,):
        if not re.fullmatch(r"3\.\d\d?", version) or version not in PYTHONS:
            raise BundleError(
                f"cannot make a bundle for Python {version!r}: write a version from {PYTHONS[0]} "
                f"to {PYTHONS[-1]}, e.g. 3.12,3.13 or 3.11..3.14"
            )
    if not dots:
        return [first]
    span = PYTHONS[PYTHONS.index(first) : PYTHONS.index(last) + 1]
    if not span:
        raise BundleError(f"{text}: the first version is newer than the last one")
    return list(span)
