"""Base class of substitutions, whose text is known only during a launch."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import PurePath
from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.launch.errors import EntityTypeError
from zbot.launch.log import get_logger

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.launch.context import LaunchContext


class Substitution:
    """A placeholder for a text. The operator `/` joins substitutions as parts of a path."""

    def perform(self, context: LaunchContext) -> str:
        """Return the text."""
        raise NotImplementedError

    def describe(self) -> str:
        """Return a description for `--print` and for error messages."""
        return f"{type(self).__name__}()"

    def __format__(self, spec: str) -> str:
        """Return the text as for any object. In an f-string, a substitution is a mistake."""
        name = type(self).__name__
        get_logger("launch").warning(
            f"{name} is in an f-string, before it has its value: write a list in place of the "
            f"f-string, ['text', {name}(...)]"
        )
        return super().__format__(spec)

    def __truediv__(self, other: SomeSubstitutionsType) -> Substitution:
        from zbot.launch.substitutions.path_join import PathJoinSubstitution  # noqa: PLC0415 - cycle

        return PathJoinSubstitution([self]) / other


#: Every form of a text that actions and substitutions accept as an argument.
SomeSubstitutionsType: TypeAlias = (
    str | Substitution | PurePath | Iterable[str | Substitution | PurePath]
)


#: The same types for `isinstance`. Some launch files use this name.
SomeSubstitutionsType_types_tuple = (str, Substitution, PurePath, Iterable)


class TextSubstitution(Substitution):
    """A fixed text."""

    def __init__(self, *, text: str) -> None:
        if not isinstance(text, str):
            raise EntityTypeError("text", "a str", text)
        self.text = text

    def perform(self, context: LaunchContext) -> str:  # noqa: ARG002 - the base's signature
        """Return the text."""
        return self.text

    def describe(self) -> str:
        """Return the text in quotes."""
        return f"'{self.text}'"


def is_a_substitution(value: Any) -> bool:
    """Return whether `normalize` accepts a value."""
    if isinstance(value, (str, Substitution, PurePath)):
        return True
    return isinstance(value, (list, tuple)) and all(map(is_a_substitution, value))


def plain_text(value: str | PurePath) -> str:
    """Return a path or a text as a `str`. The text of an Enum is its value, not `Mode.FAST`."""
    return "".join([value]) if isinstance(value, str) else str(value)


def normalize(value: SomeSubstitutionsType) -> list[Substitution]:
    """Return a text as a list of substitutions.

    Raises:
        EntityTypeError: The value is not a string, a substitution or a list of these types.
    """
    if isinstance(value, Substitution):
        return [value]
    if isinstance(value, (str, PurePath)):
        return [TextSubstitution(text=plain_text(value))]
    if isinstance(value, Iterable):
        return [part for item in value for part in normalize(item)]
    raise EntityTypeError("a text", "a str, a substitution or a list of these", value)


def perform(context: LaunchContext, value: SomeSubstitutionsType) -> str:
    """Return the texts of substitutions as one text."""
    return "".join(context.perform_substitution(part) for part in normalize(value))


def describe(value: SomeSubstitutionsType) -> str:
    """Return a description of substitutions."""
    return " + ".join(part.describe() for part in normalize(value)) or "''"


def describe_list(values: Sequence[SomeSubstitutionsType]) -> str:
    """Return a description of several texts."""
    return f"[{', '.join(describe(value) for value in values)}]"


_TRUE, _FALSE = {"true", "1", "yes", "on"}, {"false", "0", "no", "off"}


def to_bool(text: str) -> bool | None:
    """Return the truth value that a text such as `true`, `no` or `1` has in YAML.

    Return None for a text that has no truth value.
    """
    word = text.strip().lower()
    if word in _TRUE:
        return True
    return False if word in _FALSE else None
