"""Factory that makes the Python classes of messages, services and actions from their specs."""

from __future__ import annotations

import functools
import linecache
import math
import os
import re
import warnings
from array import array
from typing import TYPE_CHECKING, Any

from zbot.interfaces.array_value import elements_text, fixed_default, same_elements
from zbot.interfaces.errors import UnknownFieldError, positional_field_error
from zbot.interfaces.message import (
    Action,
    ConstantsMeta,
    Impl,
    Message,
    Service,
    shown_name,
)
from zbot.interfaces.source import class_source

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.slot_type import AbstractType
    from zbot.interfaces.spec import ActionSpec, Field, MessageSpec, ServiceSpec

    Find = Callable[[str], type[Any]]  #: returns the class of a type name


class _Default:
    """Placeholder in a signature for a default value. Each message gets a new default value."""

    def __repr__(self) -> str:
        return "<default>"


class _LazyClass:
    """Descriptor of a class attribute that is made at the first access and then kept."""

    def __init__(self, make: Callable[[], type[Any]]) -> None:
        self._make = make

    def __set_name__(self, owner: type[Any], name: str) -> None:
        self._name = name

    def __get__(self, instance: object, owner: type[Any]) -> type[Any]:
        made = self._make()
        setattr(owner, self._name, made)
        return made


class _SlotTypes:
    """Descriptor of a message class's `SLOT_TYPES`, made at the first access and then kept."""

    def __get__(self, instance: object, owner: type[Message]) -> tuple[AbstractType, ...]:
        from zbot.interfaces.slot_type import slot_type  # noqa: PLC0415 - 4 ms; few programs need it

        types = tuple(slot_type(field.type) for field in owner._SPEC.fields)  # noqa: SLF001 - our own class
        setattr(owner, "SLOT_TYPES", types)  # noqa: B010 - type checkers see it as constant
        return types


_COMMON: dict[str, Any] = {
    "_DEFAULT": _Default(),
    "_INF": math.inf,
    "_NAN": math.nan,
    "_Message": Message,
    "_SlotTypes": _SlotTypes,
    "_ConstantsMeta": ConstantsMeta,
    "_array": array,
    "_bool": bool,
    "_bytes": bytes,
    "_elements_text": elements_text,
    "_float": float,
    "_getattr": getattr,
    "_int": int,
    "_len": len,
    "_property": property,
    "_range": range,
    "_same_elements": same_elements,
    "_shown_name": shown_name,
    "_str": str,
}


def make_message(spec: MessageSpec, nested: dict[str, type[Any]]) -> type[Message]:
    """Return a message class. `nested` has the class of each field that is a message."""
    names = _namespace(spec, nested)
    source = class_source(spec, is_checked=_is_checked(spec))
    filename = f"<zbot {spec.name}>"
    # With this entry, a traceback through the class shows its source lines.
    linecache.cache[filename] = (len(source), None, source.splitlines(keepends=True), filename)
    exec(compile(source, filename, "exec", dont_inherit=True), names)  # noqa: S102 - our own source
    cls: type[Message] = names[spec.name.rpartition("/")[2]]
    return cls


def make_service(spec: ServiceSpec, find: Find) -> type[Service]:
    """Return a service class. Its Event class is made at the first access."""
    attributes = {
        "Request": find(spec.request.name),
        "Response": find(spec.response.name),
        "Event": _LazyClass(functools.partial(find, spec.event.name)),
    }
    cls: type[Service] = _namespace_class(Service, spec, attributes)
    return cls


def make_action(spec: ActionSpec, find: Find) -> type[Action]:
    """Return an action class. The contents of its `Impl` are made at the first access."""
    attributes = {
        "Goal": find(spec.goal.name),
        "Result": find(spec.result.name),
        "Feedback": find(spec.feedback.name),
        "Impl": _impl(spec, find),
    }
    cls: type[Action] = _namespace_class(Action, spec, attributes)
    return cls


def module_name(type_name: str) -> str:
    """Return ROS 2's module of a class: `std_srvs.srv._set_bool` for SetBool and its parts."""
    package, kind, short = type_name.split("/")
    stem = short.partition("_")[0]
    stem = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", stem)
    stem = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", stem)
    return f"{package}.{kind}._{stem.lower()}"


def _impl(spec: ActionSpec, find: Find) -> type[Any]:
    parts = {
        "SendGoalService": spec.send_goal.name,
        "GetResultService": spec.get_result.name,
        "FeedbackMessage": spec.feedback_message.name,
        "CancelGoalService": "action_msgs/srv/CancelGoal",
        "GoalStatusMessage": "action_msgs/msg/GoalStatusArray",
    }
    attributes = {part: _LazyClass(functools.partial(find, name)) for part, name in parts.items()}
    return type("Impl", (Impl,), {"__module__": module_name(spec.name), **attributes})


def _namespace_class(base: type[Any], spec: ServiceSpec | ActionSpec, parts: dict[str, Any]) -> Any:
    attributes = {
        "__module__": module_name(spec.name),
        "__doc__": _doc(spec.name, spec.text),
        "_SPEC": spec,
        "_TYPE_NAME": spec.name,
        **parts,
    }
    return type(spec.name.rpartition("/")[2], (base,), attributes)


def _namespace(spec: MessageSpec, nested: dict[str, type[Any]]) -> dict[str, Any]:
    names = {
        **_COMMON,
        "__name__": module_name(spec.name),
        "_DOC": _doc(spec.name, spec.text),
        "_SPEC": spec,
        "_check_call": functools.partial(
            _check_call if _is_checked(spec) else _asks_for_checks, spec
        ),
        "_equals_other": functools.partial(_equals_other, spec),
    }
    for field in spec.fields:
        names.update(_field_names(spec.name, field, nested.get(field.name)))
    return names


def _field_names(type_name: str, field: Field, cls: type[Any] | None) -> dict[str, Any]:
    names: dict[str, Any] = {f"_check_{field.name}": _LazyFieldCheck(type_name, field, cls)}
    kind = field.type
    if cls is not None:
        names[f"_class_{field.name}"] = cls
    if kind.kind == "array" and kind.typecode:
        default = field.default if isinstance(field.default, tuple) else None
        names[f"_new_{field.name}"] = fixed_default(kind.typecode, kind.size, default)
    return names


class _LazyFieldCheck:
    """Slow check of one field's values. The check is made when the first value needs it."""

    __slots__ = ("_check", "_cls", "_field", "_type_name")

    def __init__(self, type_name: str, field: Field, cls: type[Any] | None) -> None:
        self._type_name, self._field, self._cls = type_name, field, cls
        self._check: Callable[[str, Any], Any] | None = None

    def __call__(self, value: Any) -> Any:
        if self._check is None:
            # Imported here because many programs never need it.
            from zbot.interfaces.field_check import field_check  # noqa: PLC0415

            self._check = field_check(self._type_name, self._field.type, self._cls)
        return self._check(self._field.name, value)


def _is_checked(spec: MessageSpec) -> bool:
    """Return whether messages check all values. With `ROS_PYTHON_CHECK_FIELDS=0` they do not."""
    has_own = any(field.name == "check_fields" for field in spec.fields)
    return has_own or os.environ.get("ROS_PYTHON_CHECK_FIELDS") != "0"


def _asks_for_checks(spec: MessageSpec, args: tuple[Any, ...], unknown: dict[str, Any]) -> bool:
    """Return whether `check_fields` is true. If so, or if there are `args`, check the call."""
    is_asked = bool(unknown.get("check_fields"))
    if args or is_asked:
        _check_call(spec, args, unknown)
    return is_asked


def _check_call(spec: MessageSpec, args: tuple[Any, ...], unknown: dict[str, Any]) -> None:
    """Reject arguments that are not fields. `check_fields` is accepted without effect."""
    fields = tuple(field.name for field in spec.fields)
    if args:
        raise positional_field_error(spec.name, fields)
    for name in unknown:
        if name != "check_fields":
            raise UnknownFieldError(spec.name, name, fields)


def _equals_other(spec: MessageSpec, other: object) -> bool:
    """Return `False`. Warn of a message that is compared with a text or number by mistake."""
    if isinstance(other, (str, int, float)) and spec.fields:
        names = [field.name for field in spec.fields]
        advice = f"compare its field, e.g. message.{names[0]} == {other!r}"
        all_names = f" (it has {', '.join(names)})" if len(names) > 1 else ""
        text = f"a {spec.name} is compared with {other!r}, and they always differ: "
        warnings.warn(f"{text}{advice}{all_names}", stacklevel=3)
    return False


def _doc(name: str, text: str) -> str:
    return f"{name}\n\n{text}" if text else name
