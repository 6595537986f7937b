"""The parameters of one node: what is declared, and who is asked and told when one changes."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.names import validate_parameter_name
from zbot.parameters.errors import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterDeclarationError,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from zbot.parameters.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from zbot.parameters.validation import Descriptor, is_wrong_type, refusal, widened

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

    Parameters = list[Parameter[Any]]

_EMPTIED = (
    "parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying "
    "the original parameters list."
)


@dataclass(slots=True)
class Changes:
    """What one setting changed; the lists of rcl_interfaces/msg/ParameterEvent."""

    new: Parameters = field(default_factory=list)
    changed: Parameters = field(default_factory=list)
    deleted: Parameters = field(default_factory=list)


class Declaration(NamedTuple):
    """What a node declares: a name, a default value or a type alone, and the rules for it."""

    name: str
    value: Any = None
    descriptor: Descriptor = Descriptor()

    def resolved(self) -> Declaration:
        """Return it with its type in the descriptor.

        Raises:
            ParameterDeclarationError: The type is missing, or given twice.
            ParameterTypeError: No parameter can have the default value.
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
    """Declares, sets and forgets parameters by rclpy's rules.

    Every change goes the same way: pre-set callbacks may replace the list, the descriptors and then
    the on-set callbacks may refuse it, and once it is done the event is published and the post-set
    callbacks are told. Of each kind, the callback that was added last is called first.

    Args:
        publish: Called with the changes after each.
        overrides: What wins over declared defaults, by name.
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
        self.pre_set: list[Callable[[Parameters], Parameters]] = []
        #: each returns why it refuses, empty if it does not
        self.on_set: list[Callable[[Parameters], str]] = []
        self.post_set: list[Callable[[Parameters], object]] = []
        self._publish = publish

    # -- asking --------------------------------------------------------------------------------

    def get(self, name: str) -> Parameter[Any]:
        """Return a parameter.

        Raises:
            ParameterNotDeclaredException: It is unknown, and that is not allowed.
            ParameterUninitializedException: Only its type was declared, and it has no value yet.
        """
        parameter = self.values.get(name)
        if parameter is None:
            self._require_undeclared_allowed([name])
            return Parameter(name)
        is_set = parameter.type_ is not Parameter.Type.NOT_SET
        if not is_set and not self.descriptors[name].dynamic_typing:
            raise ParameterUninitializedException(name)
        return parameter

    def type_of(self, name: str) -> Parameter.Type:
        """Return the type of the present value.

        Raises:
            ParameterNotDeclaredException: It is unknown, and that is not allowed.
        """
        if name not in self.values:
            self._require_undeclared_allowed([name])
            return Parameter.Type.NOT_SET
        return self.values[name].type_

    def describe(self, name: str) -> Descriptor:
        """Return a parameter's descriptor, with the type of its present value if that may change.

        Raises:
            ParameterNotDeclaredException: It is unknown, and that is not allowed.
        """
        if name not in self.descriptors:
            self._require_undeclared_allowed([name])
            return Descriptor()
        return self.descriptors[name]

    def below(self, prefix: str) -> dict[str, Parameter[Any]]:
        """Return the parameters of a group, by their names without it; all for an empty prefix."""
        start = f"{prefix}{PARAMETER_SEPARATOR_STRING}" if prefix else ""
        found = list(self.values.items())
        return {name[len(start) :]: one for name, one in found if name.startswith(start)}

    def names(self, prefixes: Sequence[str], depth: int) -> list[str]:
        """Return the names below some prefixes, at most `depth` levels of them; 0: all levels."""
        return [
            name
            for name in list(self.values)
            if any(_is_below(name, prefix, depth) for prefix in prefixes or ("",))
        ]

    def _require_undeclared_allowed(self, names: Iterable[str]) -> None:
        unknown = [name for name in names if name not in self.values]
        if unknown and not self.allow_undeclared:
            raise ParameterNotDeclaredException(unknown, self.values)

    # -- declaring -----------------------------------------------------------------------------

    def declare(
        self, declarations: Iterable[Declaration], *, ignore_override: bool = False
    ) -> Parameters:
        """Declare parameters one by one, and return them.

        Raises:
            InvalidParameterError: A name is empty.
            ParameterDeclarationError: A declaration contradicts itself; nothing was declared.
            ParameterAlreadyDeclaredException: As it says; nothing was declared.
            InvalidParameterTypeException: An override has another type.
            InvalidParameterValueException: The descriptor or a callback refuses the value.
        """
        wanted = list(declarations)
        for one in wanted:
            validate_parameter_name(one.name)
        resolved = [one.resolved() for one in wanted]
        known = [one.name for one in resolved if one.name in self.values]
        if known:
            raise ParameterAlreadyDeclaredException(known)
        for one in resolved:
            self._declare(one, ignore_override=ignore_override)
        return [self.values[one.name] for one in resolved]

    def _declare(self, wanted: Declaration, *, ignore_override: bool) -> None:
        name = wanted.name
        override = None if ignore_override else self.overrides.get(name)
        parameter = Parameter(name, value=wanted.value) if override is None else override
        parameter = widened(parameter, wanted.descriptor)
        reason = refusal(parameter, wanted.descriptor, check_read_only=False)
        if reason and is_wrong_type(parameter, wanted.descriptor):
            raise InvalidParameterTypeException(parameter, wanted.descriptor.type.name)
        reason = reason or self._veto([parameter])
        if reason:
            raise InvalidParameterValueException(name, parameter.value, reason)
        self.descriptors[name] = wanted.descriptor
        self._commit([parameter], keep_unset=True)

    def undeclare(self, name: str) -> None:
        """Forget a parameter.

        Raises:
            ParameterNotDeclaredException: There is none of that name.
            ParameterImmutableException: It is read-only.
        """
        if name not in self.values:
            raise ParameterNotDeclaredException(name, self.values)
        if self.descriptors[name].read_only:
            raise ParameterImmutableException(name)
        del self.values[name], self.descriptors[name]
        self._publish(Changes(deleted=[Parameter(name)]))

    # -- setting -------------------------------------------------------------------------------

    def set(self, parameters: Parameters) -> str:
        """Set all of the parameters, or none of them; of two values for one name, the last.

        One without a value is undeclared, if its typing is dynamic.

        Returns:
            Why they are refused; empty if they are set.

        Raises:
            ParameterNotDeclaredException: One is unknown, and that is not allowed.
        """
        if self.pre_set:
            parameters = [one for callback in list(self.pre_set) for one in callback(parameters)]
            if not parameters:
                return _EMPTIED
        self._require_undeclared_allowed(one.name for one in parameters)
        last = {one.name: one for one in parameters}
        parameters = [self._widened(one) for one in last.values()]
        reason = next(filter(None, map(self._refusal, parameters)), "") or self._veto(parameters)
        if not reason:
            self._commit(parameters, keep_unset=False)
        return reason

    def _widened(self, parameter: Parameter[Any]) -> Parameter[Any]:
        descriptor = self.descriptors.get(parameter.name)
        return parameter if descriptor is None else widened(parameter, descriptor)

    def _refusal(self, parameter: Parameter[Any]) -> str:
        descriptor = self.descriptors.get(parameter.name)
        if descriptor is None:
            return ""
        return refusal(parameter, descriptor, self.values.get(parameter.name))

    def _veto(self, parameters: Parameters) -> str:
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
            self._keep(parameter)
        self._publish(changes)
        for callback in list(self.post_set):
            callback(parameters)

    def _keep(self, parameter: Parameter[Any]) -> None:
        descriptor = self.descriptors.get(parameter.name, Descriptor(dynamic_typing=True))
        if descriptor.dynamic_typing:
            descriptor = descriptor.with_type(parameter.type_)
        self.descriptors[parameter.name] = descriptor
        self.values[parameter.name] = parameter

    def set_descriptor(
        self, name: str, descriptor: Descriptor, alternative: Parameter[Any] | None
    ) -> Parameter[Any]:
        """Describe a parameter anew, and return it.

        Args:
            name: Which one.
            descriptor: The new rules; a type of NOT_SET means that of the value.
            alternative: Taken if the present value breaks the new rules.

        Raises:
            ParameterNotDeclaredException: It is unknown, and that is not allowed.
            ParameterImmutableException: It is read-only.
            InvalidParameterValueException: Neither value complies.
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
            reason = refusal(parameter, descriptor, check_read_only=False)
            if not reason:
                self.descriptors[name] = descriptor
                self._keep(parameter)
                return parameter
        raise InvalidParameterValueException(name, candidates[-1].value, reason)


def prefixes_of(names: Iterable[str]) -> Iterator[str]:
    """Yield each group that some of the names lie in, once."""
    seen = dict.fromkeys(name.rpartition(PARAMETER_SEPARATOR_STRING)[0] for name in names)
    return (prefix for prefix in seen if prefix)


def _is_below(name: str, prefix: str, depth: int) -> bool:
    if prefix == name:
        return True
    start = f"{prefix}{PARAMETER_SEPARATOR_STRING}" if prefix else ""
    levels = name[len(start) :].count(PARAMETER_SEPARATOR_STRING)
    return name.startswith(start) and (not depth or levels < depth)
