"""Parameters of a node, with rclpy's methods."""

from __future__ import annotations

import warnings
from copy import copy
from itertools import count, repeat
from typing import TYPE_CHECKING, Any, cast

from zbot.errors import ArgumentTypeError
from zbot.executor.callback_check import check_callback
from zbot.node.private_aliases import Alias
from zbot.parameters.errors import ParameterListError, UnknownCallbackError
from zbot.parameters.parameter import Parameter, infer_parameter, parameter_value_to_python
from zbot.parameters.store import Declaration, prefixes_of
from zbot.parameters.validation import REL_TOL, Descriptor

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from zbot.node.state import NodeState
    from zbot.parameters.store import ParameterStore

    from rcl_interfaces.msg import (
        ListParametersResult,
        ParameterDescriptor,
        ParameterValue,
        SetParametersResult,
    )

    Parameters = list[Parameter[Any]]
    PreSet = Callable[[Parameters], Parameters]
    OnSet = Callable[[Parameters], SetParametersResult]
    PostSet = Callable[[Parameters], object]

USE_SIM_TIME = "use_sim_time"
START_TYPE_DESCRIPTION_SERVICE = "start_type_description_service"

_TYPE_SERVICE_TEXT = "Start the ~/get_type_description service for this node."
_NAME_ONLY = """\
when declaring parameter named '{name}', declaring a parameter only providing its name is \
deprecated. You have to either:
\t- Pass a name and a default value different to "PARAMETER NOT SET" (and optionally a descriptor).
\t- Pass a name and a parameter type.
\t- Pass a name and a descriptor with `dynamic_typing=True`"""


class NodeParameters:
    """rclpy's parameter methods. The subclass has a `ParameterStore`."""

    _zbot_state: NodeState

    PARAM_REL_TOL = REL_TOL  #: relative tolerance of doubles at the steps and limits of a range

    #: rclpy's private attributes, as copies.
    _parameters = Alias("_zbot_state.parameters.values", copy)
    _parameter_overrides = Alias("_zbot_state.parameters.overrides", copy)
    _pre_set_parameters_callbacks = Alias("_zbot_state.parameters.pre_set", copy)
    _on_set_parameters_callbacks = Alias("_zbot_state.parameters.on_set", copy)
    _post_set_parameters_callbacks = Alias("_zbot_state.parameters.post_set", copy)

    @property
    def _zbot_parameters(self) -> ParameterStore:
        return self._zbot_state.parameters

    def _zbot_declare_overrides(self) -> None:
        """Declare every parameter that has an override, with the type of the override's value."""
        store = self._zbot_parameters
        store.declare(
            Declaration(name, override.value) for name, override in store.overrides.items()
        )

    def _zbot_declare_own(self) -> None:
        store = self._zbot_parameters
        services = Descriptor(description=_TYPE_SERVICE_TEXT, read_only=True)
        own = [
            Declaration(USE_SIM_TIME, False),
            Declaration(START_TYPE_DESCRIPTION_SERVICE, True, services),
        ]
        store.declare(declaration for declaration in own if declaration.name not in store.values)

    def declare_parameter(
        self,
        name: str,
        value: Any = None,
        descriptor: ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter[Any]:
        """Declare a parameter, and return it with its value.

        Args:
            name: Name of the parameter. Dots separate its groups.
            value: The default, or a `Parameter.Type` for a parameter without a default. An override
                from the command line or from a file replaces the default.
            descriptor: Description, range and typing. The descriptor's name and type are ignored.
            ignore_override: Whether to use the default even if there is an override.

        Raises:
            ParameterAlreadyDeclaredException: The parameter is declared already.
            InvalidParameterError: The name is empty.
            InvalidParameterTypeException: The override has another type than the default.
            InvalidParameterValueException: The range or a callback rejects the value.
            ParameterDeclarationError: The type is missing, or is given with dynamic typing.
        """
        declaration = _declaration(name, value, descriptor, depth=3)
        return self._zbot_parameters.declare([declaration], ignore_override=ignore_override)[0]

    def declare_parameters(
        self, namespace: str, parameters: Sequence[tuple[Any, ...]], ignore_override: bool = False
    ) -> Parameters:
        """Declare several parameters, and return them.

        Args:
            namespace: Group that is put before each name, with a dot. It may be empty.
            parameters: Tuples with the first arguments of `declare_parameter`, at most three.
            ignore_override: Whether to use the defaults even if there are overrides.

        Raises:
            ParameterListError: An element is not a tuple of this form.
            ParameterError: See `declare_parameter`. The parameters before the rejected parameter
                stay declared.
        """
        # In contrast to a list comprehension, `map` has no frame: a warning counts the frames.
        declarations = list(map(_declaration_of, repeat(namespace), count(), parameters))
        return self._zbot_parameters.declare(declarations, ignore_override=ignore_override)

    def undeclare_parameter(self, name: str) -> None:
        """Undeclare a parameter without calling callbacks.

        Raises:
            ParameterNotDeclaredException: The parameter is not declared.
            ParameterImmutableException: The parameter is read-only.
        """
        self._zbot_parameters.undeclare(name)

    def has_parameter(self, name: str) -> bool:
        """Return whether a parameter is declared."""
        return name in self._zbot_parameters.values

    def get_parameter(self, name: str) -> Parameter[Any]:
        """Return a parameter.

        Raises:
            ParameterNotDeclaredException: The node requires a declaration, and there is none.
            ParameterUninitializedException: The parameter has a declared type but no value.
        """
        return self._zbot_parameters.get(name)

    def get_parameters(self, names: list[str]) -> Parameters:
        """Return several parameters. See `get_parameter`."""
        return [self._zbot_parameters.get(name) for name in _checked_names(names)]

    def get_parameter_or(
        self, name: str, alternative_value: Parameter[Any] | None = None
    ) -> Parameter[Any]:
        """Return a parameter if it is declared and has a value, else the alternative."""
        found = self._zbot_parameters.values.get(name)
        if found is not None and found.type_ is not Parameter.Type.NOT_SET:
            return found
        return Parameter(name) if alternative_value is None else alternative_value

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter[Any]]:
        """Return a group's parameters. The keys are the names without the prefix.

        An empty prefix selects all parameters.
        """
        return self._zbot_parameters.in_group(prefix)

    def get_parameter_type(self, name: str) -> Parameter.Type:
        """Return the type of a parameter's value.

        Raises:
            ParameterNotDeclaredException: The node requires a declaration, and there is none.
        """
        return self._zbot_parameters.type_of(name)

    def get_parameter_types(self, names: list[str]) -> list[Parameter.Type]:
        """Return the types of several parameters. See `get_parameter_type`."""
        return [self._zbot_parameters.type_of(name) for name in _checked_names(names)]

    def list_parameters(self, prefixes: list[str], depth: int) -> ListParametersResult:
        """Return the names of parameters and of their groups.

        Args:
            prefixes: Groups to list. An empty list means all parameters.
            depth: Number of levels below the prefixes. 0 means all levels.

        Raises:
            ArgumentTypeError: An argument has a wrong type.
            ValueError: The depth is negative.
        """
        from rcl_interfaces.msg import ListParametersResult  # noqa: PLC0415 - the import makes the class

        if not isinstance(prefixes, list):
            raise ArgumentTypeError("prefixes", "a list of str", prefixes)
        if not isinstance(depth, int):
            raise ArgumentTypeError("depth", "an int", depth)
        if depth < 0:
            raise ValueError(f"depth must be 0 or more, not {depth}")
        names = self._zbot_parameters.names(_checked_names(prefixes), depth)
        return ListParametersResult(names=names, prefixes=list(prefixes_of(names)))

    def describe_parameter(self, name: str) -> ParameterDescriptor:
        """Return the descriptor of a parameter.

        Raises:
            ParameterNotDeclaredException: The node requires a declaration, and there is none.
        """
        found = self._zbot_parameters.describe(name)
        return found.to_message(name if self.has_parameter(name) else "")

    def describe_parameters(self, names: list[str]) -> list[ParameterDescriptor]:
        """Return the descriptors of several parameters. See `describe_parameter`."""
        return [NodeParameters.describe_parameter(self, name) for name in _checked_names(names)]

    def set_parameters(self, parameter_list: Parameters) -> list[SetParametersResult]:
        """Set parameters one after the other, and return the result of each.

        An element without a value undeclares the parameter if the parameter's typing is dynamic.

        Raises:
            ParameterNotDeclaredException: The node requires declarations, and a parameter is not
                declared. The earlier parameters of the list stay set.
            ParameterListError: An element is not a `Parameter`.
        """
        checked = _checked_parameters(parameter_list)
        return [_result(self._zbot_parameters.set([parameter])) for parameter in checked]

    def set_parameters_atomically(self, parameter_list: Parameters) -> SetParametersResult:
        """Set all of the parameters or none, and return the result. See `set_parameters`."""
        return _result(self._zbot_parameters.set(_checked_parameters(parameter_list)))

    def set_descriptor(
        self,
        name: str,
        descriptor: ParameterDescriptor,
        alternative_value: ParameterValue | None = None,
    ) -> ParameterValue:
        """Replace the descriptor of a parameter, and return the parameter's value.

        Args:
            name: Name of the parameter.
            descriptor: The new descriptor. The name in it is ignored.
            alternative_value: The new value, if the new descriptor does not allow the old value.

        Raises:
            ParameterNotDeclaredException: The node requires a declaration, and there is none.
            ParameterImmutableException: The parameter is read-only.
            InvalidParameterValueException: The new descriptor rejects both values.
        """
        alternative: Parameter[Any] | None = None
        if alternative_value is not None:
            alternative = Parameter(name, value=parameter_value_to_python(alternative_value))
        store = self._zbot_parameters
        return store.set_descriptor(
            name, Descriptor.of(descriptor), alternative
        ).get_parameter_value()

    def add_pre_set_parameters_callback(self, callback: PreSet) -> None:
        """Add a callback that gets new values before the checks, and returns the list to set."""
        check_callback("add_pre_set_parameters_callback", callback, "(parameters)")
        self._zbot_parameters.pre_set.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: OnSet) -> None:
        """Add a callback that runs before parameters are set, and can reject the new values.

        The callback returns a `SetParametersResult`. It runs for declarations too. It must not
        change anything, because a later callback may reject the values.
        """
        check_callback("add_on_set_parameters_callback", callback, "(parameters)")
        self._zbot_parameters.on_set.insert(0, _OnSetCallback(callback))

    def add_post_set_parameters_callback(self, callback: PostSet) -> None:
        """Add a callback that runs after parameters were declared or set."""
        check_callback("add_post_set_parameters_callback", callback, "(parameters)")
        self._zbot_parameters.post_set.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: PreSet) -> None:
        """Remove a callback.

        Raises:
            UnknownCallbackError: The callback was not added.
        """
        _remove(self._zbot_parameters.pre_set, callback)

    def remove_on_set_parameters_callback(self, callback: OnSet) -> None:
        """Remove a callback.

        Raises:
            UnknownCallbackError: The callback was not added.
        """
        _remove(self._zbot_parameters.on_set, callback)

    def remove_post_set_parameters_callback(self, callback: PostSet) -> None:
        """Remove a callback.

        Raises:
            UnknownCallbackError: The callback was not added.
        """
        _remove(self._zbot_parameters.post_set, callback)


class _OnSetCallback:
    """Wrapper of a program's on-set callback. It returns why the callback rejects the values.

    If the callback accepts the values, the wrapper returns an empty string.
    """

    def __init__(self, callback: OnSet) -> None:
        self._callback = callback

    def __call__(self, parameters: Parameters) -> str:
        result: Any = self._callback(parameters)
        if not isinstance(getattr(result, "successful", None), bool):
            name = getattr(self._callback, "__qualname__", repr(self._callback))
            code = getattr(self._callback, "__code__", None)
            warnings.warn_explicit(  # at the callback's line, because no caller can mend it
                "Callback returned an invalid type, it should return SetParameterResult: "
                f"{name} returned {result!r}; end it with "
                "`return SetParametersResult(successful=True)`",
                UserWarning,
                getattr(code, "co_filename", name),
                getattr(code, "co_firstlineno", 0),
            )
            return f"Callback returned an invalid type: {name} returned {result!r}"
        return "" if result.successful else result.reason or "a callback of the node refuses it"

    def __eq__(self, other: object) -> bool:
        """Return whether the other object is the wrapped callback, or a wrapper of it."""
        return self._callback == (other._callback if isinstance(other, _OnSetCallback) else other)

    def __hash__(self) -> int:
        return hash(self._callback)


def _remove(callbacks: list[Any], callback: Any) -> None:
    if callback not in callbacks:
        raise UnknownCallbackError(callback)
    callbacks.remove(callback)


def _declaration(name: str, value: Any, descriptor: Any, *, depth: int) -> Declaration:
    """Return a declaration. `depth` is the number of frames up to the program, for a warning."""
    if value is None and descriptor is None:
        warnings.warn(_NAME_ONLY.format(name=name), stacklevel=depth)
        return Declaration(name, None, Descriptor(dynamic_typing=True))
    if hasattr(value, "double_array_value"):
        value = parameter_value_to_python(cast("Any", value))
    if descriptor is not None and not hasattr(descriptor, "dynamic_typing"):
        raise ArgumentTypeError("descriptor", "a ParameterDescriptor", descriptor)
    rules = Descriptor() if descriptor is None else Descriptor.of(descriptor)
    return Declaration(name, value, rules)


def _declaration_of(namespace: str, index: int, item: Any) -> Declaration:
    if not isinstance(item, (tuple, list)) or not 1 <= len(item) <= 3:
        raise ParameterListError(index, item, "a tuple (name, value, descriptor)")
    name, value, descriptor = (*item, None, None)[:3]
    if not isinstance(name, str):
        raise ParameterListError(index, item, "a tuple that begins with a str")
    if len(item) == 3 and not hasattr(descriptor, "dynamic_typing"):
        raise ParameterListError(index, item, "a tuple that ends with a ParameterDescriptor")
    full = f"{namespace}.{name}" if namespace else name
    # Programs for ROS 2 Foxy declare (name, None) if a parameter file has the value. zbot treats
    # this as a declaration with only a name.
    return _declaration(full, value, descriptor, depth=4)


def _checked_names(names: Iterable[Any]) -> list[str]:
    checked = list(names)
    for index, name in enumerate(checked):
        if not isinstance(name, str):
            raise ParameterListError(index, name, "a name")
    return checked


def _checked_parameters(parameters: Iterable[Any]) -> Parameters:
    # The error of a dictionary tells how to write its items.
    checked = list(parameters.items() if isinstance(parameters, dict) else parameters)
    for index, item in enumerate(checked):
        if not isinstance(item, Parameter):
            raise ParameterListError(index, item, "a Parameter")
    return checked


def _result(reason: str) -> SetParametersResult:
    from rcl_interfaces.msg import SetParametersResult  # noqa: PLC0415 - the import makes the class

    return SetParametersResult(successful=not reason, reason=reason)


def overrides_of(values: dict[str, Any]) -> dict[str, Parameter[Any]]:
    """Return a node's overrides as parameters."""
    return {name: infer_parameter(name, value) for name, value in values.items()}
