"""Base class of all parts of a launch description, and the source line that created a part."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.launch.errors import EntityTypeError

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Iterable, Sequence

    from zbot.launch.context import LaunchContext

# Folders with the code of launch itself. `calling_line` skips the frames of this code.
_OWN = tuple(
    str(folder) for folder in (Path(__file__).parent, Path(__file__).parents[1] / "compat")
)


@dataclass(frozen=True, slots=True)
class Origin:
    """A line of a launch file."""

    path: str
    line: int  #: starts at 1


class LaunchDescriptionEntity:
    """Base class of actions and descriptions."""

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Process the entity and return the entities to visit next."""
        del context
        return None

    def describe(self) -> str:
        """Return a description in one line.

        Raises:
            NotImplementedError: The class does not override this method.
        """
        raise NotImplementedError

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that are always visited after this entity."""
        return []

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Sequence[LaunchDescriptionEntity]]]:
        """Return pairs of a condition, as text, and the entities to visit if it is true."""
        return []

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Return a future that is done when the entity has ended.

        Return None if the entity has already ended when `visit` returns.
        """
        return None


def calling_line() -> Origin | None:
    """Return the line of user code that called launch, or None if no user code called it."""
    frame = sys._getframe(1)  # noqa: SLF001 - documented; `inspect` takes 10 ms to import
    while frame is not None:
        name = frame.f_code.co_filename
        if not name.startswith(_OWN) and not name.startswith("<"):
            return Origin(name, frame.f_lineno)
        frame = frame.f_back  # type: ignore[assignment]
    return None


def entity_list(where: str, entities: Iterable[LaunchDescriptionEntity]) -> list[Any]:
    """Return actions and descriptions as a list.

    Raises:
        EntityTypeError: An action was given in place of a list.
    """
    if isinstance(entities, LaunchDescriptionEntity):
        raise EntityTypeError(where, "given a list, [...]", entities)
    return list(entities)
