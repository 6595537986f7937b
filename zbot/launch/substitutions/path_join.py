"""Substitutions that join paths and texts."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from zbot.launch.substitution import Substitution, describe, normalize, perform

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class PathJoinSubstitution(Substitution):
    """A path that consists of several parts. The operator `/` appends one more part."""

    def __init__(self, substitutions: Iterable[SomeSubstitutionsType]) -> None:
        self.substitutions = [normalize(part) for part in substitutions]

    def perform(self, context: LaunchContext) -> str:
        """Return the joined path."""
        parts = [perform(context, part) for part in self.substitutions]
        return os.path.join(*parts) if parts else ""  # noqa: PTH118 - pathlib drops a last "/"

    def describe(self) -> str:
        """Return the parts."""
        return f"PathJoin({', '.join(describe(part) for part in self.substitutions)})"

    def __truediv__(self, other: SomeSubstitutionsType) -> PathJoinSubstitution:
        return PathJoinSubstitution([*self.substitutions, other])


class PathSubstitution(PathJoinSubstitution):
    """A path to which `/` appends parts: `PathSubstitution(FindPackageShare("p")) / "x.yaml"`."""

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__([path])


class StringJoinSubstitution(Substitution):
    """Several texts with a delimiter between them."""

    def __init__(
        self, substitutions: Iterable[SomeSubstitutionsType], delimiter: SomeSubstitutionsType = ""
    ) -> None:
        self.substitutions = [normalize(part) for part in substitutions]
        self.delimiter = normalize(delimiter)

    def perform(self, context: LaunchContext) -> str:
        """Return the joined text."""
        delimiter = perform(context, self.delimiter)
        return delimiter.join(perform(context, part) for part in self.substitutions)
