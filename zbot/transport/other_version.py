"""Sentences about programs and machines that have another version of zbot."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Mapping

_MOST_LISTED = 5


def other_versions_text(versions: Mapping[str, str]) -> str:
    """Return a sentence about those that have another version than this zbot, or `""`.

    Args:
        versions: The version of each program or machine, by a text such as `Ana (number 17)`. An
            empty version is unknown.
    """
    others = [f"{who} has {version}" for who, version in versions.items() if _differs(version)]
    if not others:
        return ""
    more = f" and {len(others) - _MOST_LISTED} more" if len(others) > _MOST_LISTED else ""
    return (
        f"zbot has different versions: {', '.join(others[:_MOST_LISTED])}{more}, and this machine "
        f"has {__version__}. Install one version everywhere"
    )


def _differs(version: str) -> bool:
    return bool(version) and version != __version__
