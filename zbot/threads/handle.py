"""Handle of an entity. rclpy programs use it in a `with` block and give it to a `WaitSet`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, TypeVar

from zbot.errors import InvalidHandleError

if TYPE_CHECKING:
    from typing_extensions import Self

EntityT_co = TypeVar("EntityT_co", covariant=True)


class Handle(Generic[EntityT_co]):
    """A reference to an entity of zbot. A `WaitSet` takes such references.

    Args:
        entity: The entity.
    """

    def __init__(self, entity: EntityT_co) -> None:
        self._entity = entity

    @property
    def entity(self) -> EntityT_co:
        """The entity."""
        return self._entity

    @property
    def pointer(self) -> int:
        """A number that no other living entity has."""
        return id(self.entity)

    def destroy_when_not_in_use(self) -> None:
        """Destroy the entity."""
        entity: Any = self.entity
        entity.destroy()

    def __enter__(self) -> Self:
        if getattr(self.entity, "is_destroyed", False):
            raise InvalidHandleError(f"this {type(self.entity).__name__}")
        return self

    def __exit__(self, *exc_info: object) -> None:
        """Do nothing."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Handle) and other.entity is self.entity

    def __hash__(self) -> int:
        return self.pointer
