"""Whatever can stand in a launch description, and the line that put it there."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Sequence

    from zbot.launch.context import LaunchContext

# Frames of these folders are launch itself: the line that is asked for called into them.
_OWN = tuple(
    str(folder) for folder in (Path(__file__).parent, Path(__file__).parents[1] / "compat")
)


@dataclass(frozen=True, slots=True)
class Origin:
    """A line of a launch file."""

    path: str
    line: int  #: from 1


class LaunchDescriptionEntity:
    """What a launch description is made of."""

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Do what the entity is for; return what is to be visited next."""
        del context
        return None

    def describe(self) -> str:
        """Return one line about it.

        Raises:
            NotImplementedError: Its class has none to return.
        """
        raise NotImplementedError

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return what is visited with it for certain."""
        return []

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Sequence[LaunchDescriptionEntity]]]:
        """Return what is visited under conditions, with a phrase for each."""
        return []

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Return a future that is done when the entity is; None if it is at once."""
        return None


def calling_line() -> Origin | None:
    """Return the nearest line on the call stack that is not launch's own."""
    frame = sys._getframe(1)  # noqa: SLF001 - documented; `inspect` takes 10 ms to import
    while frame is not None:
        name = frame.f_code.co_filename
        if not name.startswith(_OWN) and not name.startswith("<"):
            return Origin(name, frame.f_lineno)
        frame = frame.f_back  # type: ignore[assignment]
    return None
