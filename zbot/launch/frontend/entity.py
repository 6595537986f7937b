"""Tree of the tags in a launch file. The tree is the same for an XML file and for a YAML file."""

from __future__ import annotations

from typing import Any, get_args

from zbot.launch.argument_names import question_about
from zbot.launch.errors import (
    AttributeTypeError,
    CoercionError,
    InvalidFrontendLaunchFileError,
    MissingAttributeError,
)
from zbot.launch.substitution import to_bool
from zbot.launch.typed_value import get_typed_value, is_instance_of, is_typing_list

#: Types of the items in an attribute's list. For another item type, `get_attr` returns children.
_LISTS = ((bool,), (int,), (float,), (str,))


class Entity:
    """A tag with its attributes and children.

    Args:
        type_name: The tag's name.
        attributes: The tag's attributes, as they are in the file.
        children: The entities inside this tag.
        path: The file.
        line: The line number in the file, which starts at 1.
        parent: The entity that contains this tag.
        written: The attributes as text and lists of text, exactly as they are written. By default,
            the same as `attributes`.
    """

    def __init__(
        self,
        type_name: str,
        attributes: dict[str, Any],
        children: list[Entity],
        path: str,
        line: int,
        *,
        parent: Entity | None = None,
        written: dict[str, Any] | None = None,
    ) -> None:
        self.type_name, self.attributes = type_name, attributes
        self._written = attributes if written is None else written
        self.path, self.line, self.parent = path, line, parent
        self._children = children
        self._used: set[str] = set()
        self._all_used = False
        for child in children:
            child.parent = self

    @property
    def children(self) -> list[Entity]:
        """The entities inside this entity. This call marks all of them as used."""
        self._all_used = True
        return self._children

    def add(self, child: Entity) -> None:
        """Append a child."""
        self._children.append(child)

    def text(self, name: str) -> str | None:
        """Return an attribute as text, or None if it is missing."""
        if self.value(name) is None:
            return None
        text = self.written(name)
        return text if isinstance(text, str) else str(self.value(name))

    def required(self, name: str) -> str:
        """Return an attribute as text.

        Raises:
            MissingAttributeError: The attribute is missing.
        """
        value = self.text(name)
        if value is None:
            raise self._missing(name)
        return value

    def _missing(self, name: str) -> MissingAttributeError:
        reason = f"`{self.type_name}` needs the attribute '{name}'"
        wrong = [attribute for attribute in self.attributes if question_about(attribute, [name])]
        hint = f"write {name}, not {wrong[0]}" if wrong else ""
        return MissingAttributeError(self.path, self.line, reason, hint)

    def value(self, name: str) -> Any:
        """Return an attribute without conversion. In YAML, the value may be a number or a list."""
        self._used.add(name)
        return self.attributes.get(name)

    def written(self, name: str) -> Any:
        """Return an attribute as a text or a list of texts, or None if it is missing.

        In YAML, these are the words of the file: `010`, and not the number 8.
        """
        self._used.add(name)
        return self._written.get(name)

    def children_of_type(self, type_name: str) -> list[Entity]:
        """Return the children that have a given tag name."""
        self._used.add(type_name)
        return [child for child in self._children if child.type_name == type_name]

    def get_attr(
        self,
        name: str,
        *,
        data_type: Any = str,
        optional: bool = False,
        can_be_str: bool = True,
    ) -> Any:
        """Return an attribute or children. The arguments are the same as in launch.

        Args:
            name: The name of the attribute, or the tag name of the children.
            data_type: `str`, `int`, `float`, `bool`, or a list whose items have one of these types,
                e.g. `List[int]`. With None, the text is read as YAML, and the value has the type
                that YAML gives it. `List[Entity]` returns children.
            optional: Whether to return None if the attribute is missing.
            can_be_str: Whether a string with substitutions is accepted for any type.

        Raises:
            AttributeTypeError: The attribute has another type.
            MissingAttributeError: The attribute is missing.
        """
        if is_typing_list(data_type) and get_args(data_type) not in _LISTS:
            found = self.children_of_type(name)
            if not found and not optional:
                raise MissingAttributeError(
                    self.path, self.line, f"`{self.type_name}` needs `{name}` inside it"
                )
            return found or None
        value = self.text(name) if data_type is str else self.value(name)
        if value is None:
            if optional:
                return None
            raise self._missing(name)
        return self._typed(name, value, data_type, can_be_str)

    def _typed(self, name: str, value: Any, data_type: Any, can_be_str: bool) -> Any:
        if isinstance(value, str) and can_be_str and "$(" in value:
            return value
        separator = self.text(f"{name}-sep")
        try:
            if isinstance(value, str) and data_type is bool:
                value = to_bool(value)
            elif isinstance(value, str):
                text = value if separator is None else value.split(separator)
                value = get_typed_value(text, data_type)
            elif data_type is float and type(value) is int:
                value = float(value)
        except CoercionError:
            value = None
        if not is_instance_of(value, data_type, can_be_str):
            expected = getattr(data_type, "__name__", str(data_type))
            written = self.attributes[name]
            reason = f"Attribute '{name}' of `{self.type_name}` must be of type {expected}"
            raise AttributeTypeError(self.path, self.line, f"{reason}, not '{written}'")
        return value

    def error(self, reason: str, hint: str = "") -> InvalidFrontendLaunchFileError:
        """Return an error with the file and the line of this entity."""
        return InvalidFrontendLaunchFileError(self.path, self.line, reason, hint)

    def assert_entity_completely_parsed(self) -> None:
        """Check that every attribute and every child was used.

        Raises:
            InvalidFrontendLaunchFileError: An attribute or a child is unknown.
        """
        for child in () if self._all_used else self._children:
            if child.type_name not in self._used:
                hint = question_about(child.type_name, self._used)
                reason = f"`{child.type_name}` is not allowed inside `{self.type_name}`"
                raise child.error(reason, hint)
        for name in self.attributes:
            if name not in self._used:
                hint = question_about(name, self._used)
                raise self.error(f"`{self.type_name}` has no attribute '{name}'", hint)


def check_is_list_entity(data_type: Any) -> bool:
    """Return whether a type is `List[Entity]`, or a list of a subclass of `Entity`."""
    items = get_args(data_type) if is_typing_list(data_type) else ()
    return bool(items) and isinstance(items[0], type) and issubclass(items[0], Entity)
