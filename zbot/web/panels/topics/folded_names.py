"""Folded list of names: a namespace with several names is one row until the user opens it."""

from __future__ import annotations

import posixpath
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator, Sequence


@dataclass(frozen=True, slots=True)
class FoldedRow:
    """Row of a folded list: a name, or a namespace."""

    name: str  #: full name, e.g. `/robot1/scan`, or a namespace that ends with `/`: `/robot1/`
    depth: int  #: number of open namespaces around it in the list
    names: tuple[str, ...] = ()  #: all names in the namespace. Empty if the row is a name


def folded(names: Sequence[str], opened: Collection[str]) -> list[FoldedRow]:
    """Return the rows of a list of names.

    A namespace that contains all names is not a row, because it would hide everything.

    Args:
        names: Full names, in the order of the list.
        opened: The open namespaces, each with `/` at its end.
    """
    return list(_rows(names, _common_namespace(names), 0, opened))


def _rows(
    names: Sequence[str], namespace: str, depth: int, opened: Collection[str]
) -> Iterator[FoldedRow]:
    groups: dict[str, list[str]] = {}
    for name in names:
        first, slash, _ = name[len(namespace) :].partition("/")
        groups.setdefault(namespace + first + slash, []).append(name)
    for group in groups.values():
        if len(group) == 1:
            yield FoldedRow(group[0], depth)
            continue
        inner = _common_namespace(group)
        yield FoldedRow(inner, depth, tuple(group))
        if inner in opened:
            yield from _rows(group, inner, depth + 1, opened)


def _common_namespace(names: Sequence[str]) -> str:
    folders = [posixpath.dirname(name) for name in names]
    return posixpath.join(posixpath.commonpath(folders), "") if folders else "/"
