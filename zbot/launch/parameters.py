"""Node parameters in launch files. They are dictionaries, YAML files, or values with a type."""

from __future__ import annotations

import math
import os
import re
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any, Final, TypeAlias

from zbot.launch.errors import EntityTypeError
from zbot.launch.substitution import (
    Substitution,
    describe,
    normalize,
    perform,
    plain_text,
    to_bool,
)
from zbot.launch.typed_value import coerce_to_type, extract_type, type_name
from zbot.parameters.errors import ParameterValueError
from zbot.parameters.file import parse_value
from zbot.parameters.value_text import value_text, with_quotes
from zbot.text.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType

#: Maximum length of a command-line word in characters. zbot writes a longer word to a file, because
#: systems limit this length.
_MAX_WORD: Final = 10_000
_ITEM_TYPES: Final = (bool, int, float, str)
_VALUES: Final = "a bool, a number, a text or a list of one of these"
_TEXT_HINT: Final = (
    "for a text that is not YAML write ParameterValue(..., value_type=str), or type='str' in an XML"
    " or YAML file"
)
# Other names are written to a file: on a command line, `a:b` is the parameter `b` of the node `a`.
_PLAIN_NAME: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_.]*")


class ParameterValue:
    """A parameter value with its type.

    Args:
        value: The value, or substitutions that produce its text.
        value_type: `str`, `int`, `float`, `bool`, or a list whose items have one of these types,
            e.g. `List[int]`. With `str`, a text may contain anything, e.g. a URDF. None means that
            the text is read as YAML.
    """

    def __init__(self, value: Any, *, value_type: Any | None = None) -> None:
        self.value, self.value_type = value, value_type

    def evaluate(self, context: LaunchContext) -> Any:
        """Return the value.

        Raises:
            CoercionError: The text of a substitution cannot be read as this type.
            EntityTypeError: The value cannot have this type.
        """
        if self.value_type is None:
            return evaluate(context, self.value)
        return _typed(context, self.value, self.value_type)

    def describe(self) -> str:
        """Return the name of the class and the value."""
        return f"ParameterValue({self.value!r})"


class ParameterFile:
    """A YAML file with parameters.

    Args:
        param_file: The path of the file.
        allow_substs: Whether to replace substitutions in the file, such as `$(var x)`.
    """

    def __init__(
        self,
        param_file: SomeSubstitutionsType,
        *,
        allow_substs: bool | SomeSubstitutionsType = False,
    ) -> None:
        self._given = normalize(param_file)
        self._path: Path | None = None
        self.allow_substs = allow_substs

    @property
    def param_file(self) -> Any:
        """The path as a list of substitutions. After `evaluate` it is the resulting path."""
        return self._given if self._path is None else self._path

    def evaluate(self, context: LaunchContext) -> Path:
        """Return the path of the file.

        With `allow_substs`, return the path of a copy in which the substitutions are replaced.
        """
        self._path = Path(perform(context, self._given))
        allow: Any = self.allow_substs
        if not isinstance(allow, bool):
            allow = to_bool(perform(context, allow))
        if allow and self._path.is_file():
            from zbot.launch.frontend.substitution_text import parse  # noqa: PLC0415 - rare

            text = perform(context, parse(self._path.read_text(encoding="utf-8")))
            self._path = temporary_file(context, text)
        return self._path

    def describe(self) -> str:
        """Return the name of the class and the path."""
        return f"ParameterFile({describe(self._given)})"


class Parameter(ParameterValue):
    """A parameter value with its name."""

    def __init__(
        self, name: SomeSubstitutionsType, value: Any, *, value_type: Any | None = None
    ) -> None:
        super().__init__(value, value_type=value_type)
        self._given = normalize(name)
        self._name: str | None = None

    @property
    def name(self) -> Any:
        """The name as a list of substitutions. After `evaluate` it is the resulting text."""
        return self._given if self._name is None else self._name

    def evaluate(self, context: LaunchContext) -> tuple[str, Any]:
        """Return name and value.

        Raises:
            CoercionError: The text of a substitution cannot be read as this type.
            EntityTypeError: The value cannot have this type.
        """
        self._name = perform(context, self._given)
        return self._name, super().evaluate(context)


#: One item of a node's `parameters`.
SomeParameters: TypeAlias = (
    Mapping[Any, Any] | ParameterFile | Parameter | str | PurePath | Substitution
)


def normalize_parameters(parameters: Iterable[Any]) -> list[Any]:
    """Check the types of the items in `parameters`, and return the items as a list.

    Raises:
        EntityTypeError: `parameters` is not a list, or an item cannot be a parameter.
    """
    if isinstance(parameters, (str, Mapping)):
        raise EntityTypeError("parameters", "a list: parameters=[...]", parameters)
    items = list(parameters)
    for item in items:
        if isinstance(item, Mapping):
            _check(item)
        elif not isinstance(item, Parameter):
            _as_file(item)
    return items


def _check(values: Mapping[Any, Any]) -> None:
    for name, value in values.items():
        normalize(name)
        if isinstance(value, Mapping):
            _check(value)
        elif not _is_valid(value):
            raise EntityTypeError("a parameter", _VALUES, value)


def _is_valid(value: Any) -> bool:
    if isinstance(value, (*_ITEM_TYPES, bytes, bytearray, PurePath, ParameterValue, Substitution)):
        return True
    if isinstance(value, Sequence):
        return all(
            isinstance(item, (*_ITEM_TYPES, ParameterValue, Substitution))
            or _is_text_of_parts(item)
            for item in value
        )
    return callable(getattr(value, "tolist", None))  # numpy


def to_words(context: LaunchContext, parameters: Iterable[Any]) -> list[str]:
    """Return the `-p` and `--params-file` words of a command line for a list of parameters.

    Raises:
        EntityTypeError: An item cannot be a parameter.
    """
    words: list[str] = []
    for item in parameters:
        if isinstance(item, Mapping):
            for name, value in flatten(context, item):
                words += _word(context, name, value)
        elif isinstance(item, Parameter):
            words += _word(context, *item.evaluate(context))
        elif isinstance(item, tuple) and len(item) == 2 and not _is_text_of_parts(item):
            words += _word(context, str(item[0]), evaluate(context, item[1]))
        else:
            words += _file(context, item)
    return words


def evaluate_parameters(
    context: LaunchContext, parameters: Iterable[Any]
) -> tuple[dict[str, Any] | Path, ...]:
    """Return a dictionary or the path of a file for each item of a node's parameters.

    Raises:
        EntityTypeError: An item cannot be a parameter.
    """
    return tuple(_evaluated(context, item) for item in parameters)


def _evaluated(context: LaunchContext, item: Any) -> dict[str, Any] | Path:
    if isinstance(item, Mapping):
        return {name: _as_tuple(value) for name, value in flatten(context, item)}
    if isinstance(item, Parameter):
        name, value = item.evaluate(context)
        return {name: _as_tuple(value)}
    return _as_file(item).evaluate(context)


def _as_tuple(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _as_file(item: Any) -> ParameterFile:
    if isinstance(item, ParameterFile):
        return item
    try:
        return ParameterFile(item)
    except EntityTypeError:
        expected = "a dictionary, the path of a YAML file or a ParameterFile"
        raise EntityTypeError("an item of parameters", expected, item) from None


def _file(context: LaunchContext, item: Any) -> list[str]:
    path = _as_file(item).evaluate(context)
    if not path.is_file():
        context.writer.warning("launch_ros", f"Parameter file path is not a file: {path}")
        return []
    return ["--params-file", str(path)]


def _word(context: LaunchContext, name: str, value: Any) -> list[str]:
    value = list(value) if isinstance(value, bytes) else value
    text = value_text(value)
    if len(text) <= _MAX_WORD and _PLAIN_NAME.fullmatch(name):
        return ["-p", f"{name}:={text}"]
    content = value_text({"/**": {"ros__parameters": {name: with_quotes(value)}}})
    return ["--params-file", str(temporary_file(context, content))]


def flatten(
    context: LaunchContext, values: Mapping[Any, Any], prefix: str = ""
) -> list[tuple[str, Any]]:
    """Return pairs of name and value. Dots join the names of nested dictionaries."""
    found: list[tuple[str, Any]] = []
    for key, value in values.items():
        name = prefix + perform(context, key)
        if isinstance(value, Mapping):
            found += flatten(context, value, f"{name}.")
        else:
            found.append((name, evaluate(context, value)))
    return found


def evaluate(context: LaunchContext, value: Any) -> Any:
    """Return the value of a parameter. The text of substitutions is read as YAML.

    Raises:
        EntityTypeError: A parameter cannot have this value.
    """
    if isinstance(value, ParameterValue):
        return value.evaluate(context)
    if isinstance(value, Substitution) or _is_text_of_parts(value):
        text = perform(context, value)
        return _read(text)
    value = _without_numpy(value)
    if isinstance(value, str):
        return plain_text(value)
    if isinstance(value, _ITEM_TYPES):
        return value
    if isinstance(value, (bytes, bytearray)):
        return bytes(value)
    if isinstance(value, Sequence):
        return _same_kind([evaluate(context, item) for item in value])
    if isinstance(value, PurePath):
        return str(value)
    raise EntityTypeError("a parameter", _VALUES, value)


def _without_numpy(value: Any) -> Any:
    """Return the Python value of a numpy scalar or array. Other values stay unchanged."""
    tolist = getattr(value, "tolist", None)
    return tolist() if callable(tolist) and not isinstance(value, memoryview) else value


def _is_text_of_parts(value: Any) -> bool:
    """Return whether a list is one text in parts: `["prefix_", LaunchConfiguration("x")]`."""
    if not isinstance(value, (list, tuple)) or not value:
        return False
    has_substitution = any(isinstance(item, Substitution) for item in value)
    return has_substitution and all(isinstance(item, (str, Substitution)) for item in value)


def _same_kind(items: list[Any]) -> list[Any]:
    if any(isinstance(item, float) for item in items):
        items = [float(item) if type(item) is int else item for item in items]
    kinds = {type(item) for item in items}
    if len(kinds) > 1 or not kinds <= set(_ITEM_TYPES):
        raise EntityTypeError("a list parameter", "a list of values of one kind", items)
    return items


def _read(text: str) -> Any:
    """Return the value of a text without a type.

    launch reads the text by YAML's rules, and then the node reads the result by ROS 2's rules. So
    `1_000` and `1:30` are integers, and `1e3` and `nan` are floats.
    """
    if not text.strip():
        return text
    try:
        value = parse_value(text)
    except ParameterValueError as error:
        raise EntityTypeError("a parameter", f"{_VALUES} in YAML", text, _TEXT_HINT) from error
    with suppress(YamlError):  # e.g. for `=`
        value = _with_numbers(value, read_yaml(text))
    return _same_kind(value) if isinstance(value, list) else value


def _with_numbers(value: Any, by_yaml: Any) -> Any:
    """Return a value that ROS 2's rules read, with the numbers that YAML's rules read."""
    if isinstance(value, list):
        return [_with_numbers(*pair) for pair in zip(value, by_yaml, strict=True)]
    return by_yaml if isinstance(by_yaml, (bool, int, float)) else value


def _typed(context: LaunchContext, value: Any, kind: Any) -> Any:
    """Return a value of a type. The type decides how the text of substitutions is read."""
    value = _without_numpy(value)
    if isinstance(value, Substitution) or _is_text_of_parts(value):
        return coerce_to_type(perform(context, value), kind)
    item_kind, is_list = extract_type(kind)
    if is_list and isinstance(value, Sequence) and not isinstance(value, (str, bytes)):
        return [_typed(context, item, item_kind) for item in value]
    return _converted(evaluate(context, value), kind)


def _converted(value: Any, kind: Any) -> Any:
    if kind is bool and isinstance(value, bool):
        return value
    if kind is str:
        return value if isinstance(value, str) else value_text(value)
    is_number = type(value) in {int, float}
    if is_number and (kind is float or (kind is int and math.isfinite(value) and value % 1 == 0)):
        return kind(value)
    raise EntityTypeError("a parameter", type_name(kind), value)


def temporary_file(context: LaunchContext, text: str, folder: str | None = None) -> Path:
    """Return the path of a new file with this text. The end of the launch removes the file."""
    number, name = tempfile.mkstemp(prefix="launch_params_", suffix=".yaml", dir=folder)
    with os.fdopen(number, "w", encoding="utf-8") as file:
        file.write(text)
    path = Path(name)
    context.on_close(lambda: path.unlink(missing_ok=True))
    return path
