"""Grammar of ROS 2 for the names and types in a definition."""

from __future__ import annotations

import keyword
import re

from zbot.errors.suggestion import did_you_mean
from zbot.interfaces.spec import PRIMITIVES, FieldType

_PACKAGE = re.compile(r"(?!.*__)(?!.*_$)[a-z][a-z0-9_]*")
_FIELD = _PACKAGE
_CONSTANT = re.compile(r"(?!.*__)(?!.*_$)[A-Z][A-Z0-9_]*")
_MESSAGE = re.compile(r"[A-Z][A-Za-z0-9]*")
# The parts of services and actions are messages too, with an underscore in their names.
_PART = re.compile(
    r"[A-Z][A-Za-z0-9]*(_(Request|Response|Event|Goal|Result|Feedback|FeedbackMessage"
    r"|(SendGoal|GetResult)(_(Request|Response|Event))?))?"
)
_TYPE = re.compile(
    r"(?P<base>[^\[\]<>=]+)(?P<bounded><=(?P<bound>[^\[\]]*))?(?P<array>\[(?P<size>[^\[\]]*)\])?"
)
_SIZE = re.compile(r"[1-9][0-9]{0,9}", re.ASCII)
_MAX_BOUND = 2**32 - 1
# A message allocates its fixed arrays, so a typo such as `uint8[9999999999]` must be an error.
_MAX_ARRAY = 2**24
_MISTAKEN = {
    "int": "int32 (or int8, int16, int64)",
    "uint": "uint32 (or uint8, uint16, uint64)",
    "float": "float64 (or float32)",
    "double": "float64",
    "boolean": "bool",
    "str": "string",
    "bytes": "uint8[]",
    "list": "an array such as float64[]",
    "time": "builtin_interfaces/Time",
    "duration": "builtin_interfaces/Duration",
}
_ROS1_HEADER = "Header"


class GrammarError(ValueError):
    """A definition breaks a rule. The parser adds the file and the line."""


def check_interface_name(name: str) -> str:
    """Return the package of a name `pkg/msg/Name`. Raise `GrammarError` for another form."""
    package, _, rest = name.partition("/")
    kind, _, short = rest.partition("/")
    if kind not in {"msg", "srv", "action"}:
        raise GrammarError(f"{name!r} is not of the form package/msg/Name")
    if not _PACKAGE.fullmatch(package):
        raise GrammarError(_lower_case_rule("package", package))
    if not _PART.fullmatch(short):
        raise GrammarError(_camel_case_rule(short))
    return package


def check_field_name(name: str) -> None:
    """Raise `GrammarError` if a field cannot have the name."""
    if not _FIELD.fullmatch(name):
        raise GrammarError(_lower_case_rule("field", name))
    # ROS 2 rejects Python's keywords too. `self` is a parameter of the generated constructor.
    if keyword.iskeyword(name) or name == "self":
        raise GrammarError(f"field name {name!r} is reserved in Python: choose another")


def check_constant_name(name: str, value: str) -> None:
    """Raise `GrammarError` if a constant cannot have the name."""
    if _CONSTANT.fullmatch(name):
        return
    if _FIELD.fullmatch(name):
        raise GrammarError(
            f"constant name {name!r} must be upper case: {name.upper()!r}; "
            f"or, for a field with a default, leave out the '=': '{name} {value}'"
        )
    raise GrammarError(
        f"constant name {name!r} is not valid: upper case letters, digits and single underscores, "
        "e.g. 'MAX_SPEED'"
    )


def parse_type(text: str, package: str) -> FieldType:
    """Return the type for a text, e.g. `float64[3]`. A name without a package gets `package`.

    Raises:
        GrammarError: The text is not a type. The error says what to write.
    """
    match = _TYPE.fullmatch(text)
    if match is None:
        raise GrammarError(f"type {text!r} is not valid: write e.g. 'float64', 'float64[3]'")
    base = _base(match["base"], package)
    bound = 0
    if match["bounded"]:
        if base not in {"string", "wstring"}:
            raise GrammarError(f"only a string has such a bound: write '{base}[<=10]' for an array")
        bound = _size(match["bound"], f"the bound of type {text!r}", _MAX_BOUND)
    if not match["array"]:
        return FieldType(base, string_bound=bound)
    size_text = match["size"]
    if not size_text:
        return FieldType(base, "sequence", 0, bound)
    if size_text.startswith("<="):
        size = _size(size_text[2:], f"the bound of type {text!r}", _MAX_BOUND)
        return FieldType(base, "sequence", size, bound)
    size = _size(size_text, f"the size of type {text!r}", _MAX_ARRAY)
    return FieldType(base, "array", size, bound)


def _base(text: str, package: str) -> str:
    if text in PRIMITIVES:
        return text
    if text == _ROS1_HEADER:
        return "std_msgs/msg/Header"
    parts = text.split("/")
    if len(parts) == 3 and parts[1] in {"msg", "srv", "action"}:
        owner, kind, name = parts
    elif len(parts) <= 2:
        owner, kind, name = (parts[0] if len(parts) == 2 else package), "msg", parts[-1]
    else:
        raise GrammarError(f"type {text!r} is not of the form package/Name")
    if len(parts) == 1 and not _MESSAGE.fullmatch(name):
        raise GrammarError(_unknown_primitive(name))
    if not _PACKAGE.fullmatch(owner):
        raise GrammarError(_lower_case_rule("package", owner))
    if not _PART.fullmatch(name):
        raise GrammarError(_camel_case_rule(name))
    return f"{owner}/{kind}/{name}"


def _size(text: str, what: str, largest: int) -> int:
    size = int(text) if _SIZE.fullmatch(text) else 0
    if not 1 <= size <= largest:
        raise GrammarError(f"{what} must be a whole number from 1 to {largest}, not {text!r}")
    return size


def _unknown_primitive(name: str) -> str:
    if name in _MISTAKEN:
        return f"there is no type {name!r}: write {_MISTAKEN[name]}"
    hint = did_you_mean(name, PRIMITIVES) or "a message's name starts upper case"
    return f"there is no type {name!r}; {hint}"


def _lower_case_rule(kind: str, name: str) -> str:
    example = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()
    hint = f", e.g. {example!r}" if _PACKAGE.fullmatch(example) else ""
    return (
        f"{kind} name {name!r} is not valid: a lower case letter first, then lower case letters, "
        f"digits and single underscores{hint}"
    )


def _camel_case_rule(name: str) -> str:
    example = "".join(part[:1].upper() + part[1:] for part in name.split("_"))
    hint = f", e.g. {example!r}" if _MESSAGE.fullmatch(example) else ""
    return (
        f"interface name {name!r} is not valid: an upper case letter first, then letters and "
        f"digits only{hint}"
    )
