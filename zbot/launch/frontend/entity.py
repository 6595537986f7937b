"""Launch files in XML and YAML as one kind of tree."""

from __future__ import annotations

import typing
from dataclasses import dataclass, field
from typing import Any

from zbot.errors import nearest
from zbot.launch.frontend.errors import InvalidFrontendLaunchFileError
from zbot.launch.substitution import to_bool

_CONVERTERS: dict[Any, Any] = {int: int, float: float, str: str, bool: to_bool}


@dataclass(eq=False)
class Entity:
    """A tag with its attributes and what is inside it."""

    type_name: str
    attributes: dict[str, Any]
    children: list[Entity]
    path: str
    line: int
    parent: Entity | None = None
    _used: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        for child in self.children:
            child.parent = self

    def text(self, name: str) -> str | None:
        """Return an attribute as text; None if there is none."""
        self._used.add(name)
        value = self.attributes.get(name)
        if isinstance(value, bool):
            return str(value).lower()
        return None if value is None else str(value)

    def required(self, name: str) -> str:
        """Return an attribute as text.

        Raises:
            InvalidFrontendLaunchFileError: There is none.
        """
        value = self.text(name)
        if value is None:
            raise self.error(f"`{self.type_name}` needs the attribute '{name}'")
        return value

    def value(self, name: str) -> Any:
        """Return an attribute as it was written: in YAML it may be a number or a list."""
        self._used.add(name)
        return self.attributes.get(name)

    def inside(self, type_name: str) -> list[Entity]:
        """Return those children that are of a kind."""
        self._used.add(type_name)
        return [child for child in self.children if child.type_name == type_name]

    def get_attr(
        self,
        name: str,
        *,
        data_type: Any = str,
        optional: bool = False,
        can_be_str: bool = True,
    ) -> Any:
        """Return an attribute, or children of a kind, as actions of other packages ask for them.

        Args:
            name: Its name.
            data_type: `str`, `int`, `float`, `bool`, or `List[Entity]` for children.
            optional: Whether None is returned where there is none.
            can_be_str: Whether a text with substitutions will do for any type.

        Raises:
            InvalidFrontendLaunchFileError: There is none, or it is of another type.
        """
        if typing.get_origin(data_type) is list:
            found = self.inside(name)
            if not found and not optional:
                raise self.error(f"`{self.type_name}` needs `{name}` inside it")
            return found or None
        text = self.text(name) if optional else self.required(name)
        if text is None or (can_be_str and "$(" in text):
            return text
        try:
            converted = _CONVERTERS.get(data_type, str)(text)
        except ValueError:
            converted = None
        if converted is None:
            raise self.error(f"'{name}' must be of type {data_type.__name__}, not '{text}'")
        return converted

    def error(self, reason: str, hint: str = "") -> InvalidFrontendLaunchFileError:
        """Return an error that names this place."""
        return InvalidFrontendLaunchFileError(self.path, self.line, reason, hint)

    def assert_entity_completely_parsed(self) -> None:
        """Check that nobody wrote an attribute that nothing asks for.

        Raises:
            InvalidFrontendLaunchFileError: There is one.
        """
        for name in self.attributes:
            if name not in self._used:
                near = nearest(name, self._used, 1)
                hint = f"did you mean '{near[0]}'?" if near else ""
                raise self.error(f"`{self.type_name}` has no attribute '{name}'", hint)
