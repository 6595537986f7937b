"""Store of one node's parameters, with their descriptors and callbacks."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.names import validate_parameter_name
from zbot.parameters.errors import (
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterDeclarationError,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from zbot.parameters.parameter import (
    PARAMETER_SEPARATOR_STRING,
    InvalidParameterTypeException,
    Parameter,
)
from zbot.parameters.validation import Descriptor, is_wrong_type, rejection_reason, widened

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

    Parameters = list[Parameter[Any]]

_EMPTY_LIST_REASON = (
    "parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying "
    "the original parameters list."
)


@dataclass(slots=True)
class Changes:
    """Changes that one operation made, in the three lists of rcl_interfaces/msg/ParameterEvent."""

    new: Parameters = field(default_factory=list)
    changed: Parameters = field(default_factory=list)
    deleted: Parameters = field(default_factory=list)


class Declaration(NamedTuple):
    """Declaration of a parameter: its name, its descriptor, and a default value or only a type."""

    name: str
    value: Any = None
    descriptor: Descriptor = Descriptor()

    def resolved(self) -> Declaration:
        """Return a declaration whose descriptor contains the type.

        Raises:
            ParameterDeclarationError: The type is missing, or is given with dynamic typing.
            ParameterTypeError: The default value has a type that parameters cannot have.
        """
        descriptor = self.descriptor
        if isinstance(self.value, Parameter.Type):
            if self.value is Parameter.Type.NOT_SET:
                raise ParameterDeclarationError(self.name, "a static type cannot be NOT_SET")
            if descriptor.dynamic_typing:
                raise ParameterDeclarationError(
                    self.name, "give a type or dynamic_typing, not both"
                )
            return Declaration(self.name, None, descriptor.with_type(self.value))
        if descriptor.dynamic_typing:
            return self
        found = Parameter.Type.from_parameter_value(self.value)
        if found is Parameter.Type.NOT_SET:
            reason = "give it a value, a Parameter.Type, or a descriptor with dynamic_typing"
            raise ParameterDeclarationError(self.name, reason)
        return Declaration(self.name, self.value, descriptor.with_type(found))


class ParameterStore:
    """Parameters of a node. They are declared, set and undeclared by the rules of rclpy.

    `set` has these steps:

    1. The pre-set callbacks may replace the list of parameters.
    2. The descriptors, and then the on-set callbacks, may reject the list.
    3. The values are set, and the event is published.
    4. The post-set callbacks are called.

    In each step, the callback that was added last is called first.

    Args:
        publish: Function that is called with the changes after each operation.
        overrides: Values by name, which replace declared defaults.
        allow_undeclared: Whether setting an unknown parameter declares it.
    """

    def __init__(
        self,
        publish: Callable[[Changes], object],
        overrides: Mapping[str, Parameter[Any]] | None = None,
        *,
        allow_undeclared: bool = False,
    ) -> None:
        self.values: dict[str, Parameter[Any]] = {}
        self.descriptors: dict[str, Descriptor] = {}
        self.overrides = dict(overrides or {})
        self.allow_undeclared = allow_undeclared
        self.may_grow = False  #: whether the node may declare parameters long after its start
        self.pre_set: list[Callable[[Parameters], Parameters]] = []
        #: each callback returns the reason for a rejection, or an empty string
        self.on_set: list[Callable[[Parameters], str]] = []
        self.post_set: list[Callable[[Parameters], object]] = []
        self._publish = publish

    def get(self, name: str) -> Parameter[Any]:
        """Return a parameter.

        Raises:
            ParameterNotDeclaredException: The parameter is unknown, and undeclared parameters are
                not allowed.
            ParameterUninitializedException: The parameter has a type, but no value yet.
        """
        parameter = self.values.get(name)
        if parameter is None:
            advice = f"; first write self.declare_parameter({name!r}, VALUE)"
            self._require_undeclared_allowed([name], advice)
            return Parameter(name)
        is_set = parameter.type_ is not Parameter.Type.NOT_SET
        if not is_set and not self.descriptors[name].dynamic_typing:
            raise ParameterUninitializedException(name)
        return parameter

    def type_of(self, name: str) -> Parameter.Type:
        """Return the type of the current value.

        Raises:
            ParameterNotDeclaredException: The parameter is unknown, and undeclared parameters are
                not allowed.
        """
        if name not in self.values:
            self._require_undeclared_allowed([name])
            return Parameter.Type.NOT_SET
        return self.values[name].type_

    def describe(self, name: str) -> Descriptor:
        """Return a parameter's descriptor. With dynamic typing, its type is the value's type.

        Raises:
            ParameterNotDeclaredException: The parameter is unknown, and undeclared parameters are
                not allowed.
        """
        if name not in self.descriptors:
            self._require_undeclared_allowed([name])
            return Descriptor()
        return self.descriptors[name]

    def in_group(self, prefix: str) -> dict[str, Parameter[Any]]:
        """Return a group's parameters by name without prefix. An empty prefix returns all."""
        start = f"{prefix}{PARAMETER_SEPARATOR_STRING}" if prefix else ""
        found = list(self.values.items())
        return {name[len(start) :]: value for name, value in found if name.startswith(start)}

    def names(self, prefixes: Sequence[str], depth: int) -> list[str]:
        """Return the names below some prefixes, down to `depth` levels. 0 means all levels."""
        return [
            name
            for name in list(self.values)
            if any(_is_below(name, prefix, depth) for prefix in prefixes or ("",))
        ]

    def _require_undeclared_allowed(self, names: Iterable[str], advice: str = "") -> None:
        unknown = [name for name in names if name not in self.values]
        if unknown and not self.allow_undeclared:
            raise ParameterNotDeclaredException(unknown, self.values, advice)

    def declare(
        self, declarations: Iterable[Declaration], *, ignore_override: bool = False
    ) -> Parameters:
        """Declare parameters one by one, and return them.

        Raises:
            InvalidParameterError: A name is empty.
            ParameterDeclarationError: A declaration is not consistent. Nothing was declared.
            ParameterAlreadyDeclaredException: A name is declared already. Nothing was declared.
            InvalidParameterTypeException: An override has another type.
            InvalidParameterValueException: The descriptor or a callback rejects the value.
        """
        wanted = list(declarations)
        for parameter in wanted:
            validate_parameter_name(parameter.name)
        resolved = [parameter.resolved() for parameter in wanted]
        known = [parameter.name for parameter in resolved if parameter.name in self.values]
        if known:
            raise ParameterAlreadyDeclaredException(known)
        for parameter in resolved:
            self._declare(parameter, ignore_override=ignore_override)
        return [self.values[parameter.name] for parameter in resolved]

    def _declare(self, wanted: Declaration, *, ignore_override: bool) -> None:
        name = wanted.name
        override = None if ignore_override else self.overrides.get(name)
        parameter = Parameter(name, value=wanted.value) if override is None else override
        parameter = widened(parameter, wanted.descriptor)
        reason = rejection_reason(parameter, wanted.descriptor, check_read_only=False)
        if reason and is_wrong_type(parameter, wanted.descriptor):
            raise InvalidParameterTypeException(parameter, wanted.descriptor.type.name)
        reason = reason or self._callback_rejection([parameter])
        if reason:
            raise InvalidParameterValueException(name, parameter.value, reason)
        self.descriptors[name] = wanted.descriptor
        self._commit([parameter], keep_unset=True)

    def undeclare(self, name: str) -> None:
        """Remove a parameter.

        Raises:
            ParameterNotDeclaredException: No parameter has that name.
            ParameterImmutableException: The parameter is read-only.
        """
        if name not in self.values:
            raise ParameterNotDeclaredException(name, self.values)
        if self.descriptors[name].read_only:
            raise ParameterImmutableException(name)
        del self.values[name], self.descriptors[name]
        self._publish(Changes(deleted=[Parameter(name)]))

    def set(self, parameters: Parameters) -> str:
        """Set all given parameters, or set none. If a name occurs twice, its last value is set.

        An item without a value removes its parameter, if the parameter has dynamic typing.

        Returns:
            The reason for a rejection. It is empty if the parameters are set.

        Raises:
            ParameterNotDeclaredException: A parameter is unknown, and undeclared parameters are not
                allowed.
        """
        if self.pre_set:
            parameters = [
                parameter for callback in list(self.pre_set) for parameter in callback(parameters)
            ]
            if not parameters:
                return _EMPTY_LIST_REASON
        self._require_undeclared_allowed(parameter.name for parameter in parameters)
        last = {parameter.name: parameter for parameter in parameters}
        parameters = [self._widened(parameter) for parameter in last.values()]
        reason = next(
            filter(None, map(self._rejection_reason, parameters)), ""
        ) or self._callback_rejection(parameters)
        if not reason:
            self._commit(parameters, keep_unset=False)
        return reason

    def _widened(self, parameter: Parameter[Any]) -> Parameter[Any]:
        descriptor = self.descriptors.get(parameter.name)
        return parameter if descriptor is None else widened(parameter, descriptor)

    def _rejection_reason(self, parameter: Parameter[Any]) -> str:
        descriptor = self.descriptors.get(parameter.name)
        if descriptor is None:
            return ""
        return rejection_reason(parameter, descriptor, self.values.get(parameter.name))

    def _callback_rejection(self, parameters: Parameters) -> str:
        return next(filter(None, (callback(parameters) for callback in list(self.on_set))), "")

    def _commit(self, parameters: Parameters, *, keep_unset: bool) -> None:
        changes = Changes()
        for parameter in parameters:
            is_set = parameter.type_ is not Parameter.Type.NOT_SET
            if not is_set and not keep_unset:
                self.values.pop(parameter.name, None)
                self.descriptors.pop(parameter.name, None)
                changes.deleted.append(parameter)
                continue
            present = self.values.get(parameter.name)
            is_new = present is None or present.type_ is Parameter.Type.NOT_SET
            (changes.new if is_new else changes.changed).append(parameter)
            self._store(parameter)
        self._publish(changes)
        for callback in list(self.post_set):
            callback(parameters)

    def _store(self, parameter: Parameter[Any]) -> None:
        descriptor = self.descriptors.get(parameter.name, Descriptor(dynamic_typing=True))
        if descriptor.dynamic_typing:
            descriptor = descriptor.with_type(parameter.type_)
        self.descriptors[parameter.name] = descriptor
        self.values[parameter.name] = parameter

    def set_descriptor(
        self, name: str, descriptor: Descriptor, alternative: Parameter[Any] | None
    ) -> Parameter[Any]:
        """Replace a parameter's descriptor, and return the parameter.

        Args:
            name: The parameter's name.
            descriptor: The new descriptor. If its type is NOT_SET, it gets the type of the value.
            alternative: The new value if the current value does not fit the new descriptor.

        Raises:
            ParameterNotDeclaredException: The parameter is unknown, and undeclared parameters are
                not allowed.
            ParameterImmutableException: The parameter is read-only.
            InvalidParameterValueException: The current value and `alternative` do not fit.
        """
        present = self.get(name)
        if name not in self.values:
            return present
        if self.descriptors[name].read_only:
            raise ParameterImmutableException(name)
        if not descriptor.dynamic_typing and descriptor.type is Parameter.Type.NOT_SET:
            descriptor = descriptor.with_type(present.type_)
        candidates = [present] if alternative is None else [present, alternative]
        reason = ""
        for candidate in candidates:
            parameter = widened(candidate, descriptor)
            reason = rejection_reason(parameter, descriptor, check_read_only=False)
            if not reason:
                self.descriptors[name] = descriptor
                self._store(parameter)
                return parameter
        raise InvalidParameterValueException(name, candidates[-1].value, reason)


def prefixes_of(names: Iterable[str]) -> Iterator[str]:
    """Yield the groups of the names. Each group occurs only once."""
    seen = dict.fromkeys(name.rpartition(PARAMETER_SEPARATOR_STRING)[0] for name in names)
    return (prefix for prefix in seen if prefix)


def _is_below(name: str, prefix: str, depth: int) -> bool:
    if prefix == name:
        return True
    start = f"{prefix}{PARAMETER_SEPARATOR_STRING}" if prefix else ""
    levels = name[len(start) :].count(PARAMETER_SEPARATOR_STRING)
    return name.startswith(start) and (not depth or levels < depth)
