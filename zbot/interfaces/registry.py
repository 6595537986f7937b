"""Registry of interfaces by name. It loads definitions and makes classes at their first use."""

from __future__ import annotations

import threading
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

from zbot.errors import WrongValueError
from zbot.errors.suggestion import similar_names
from zbot.interfaces.classes import make_action, make_message, make_service
from zbot.interfaces.errors import InterfaceSyntaxError, UnknownInterfaceError, UnknownPackageError
from zbot.interfaces.location import (
    definition_file,
    interface_files,
    known_packages,
    package_folder,
)
from zbot.interfaces.message import rebuild
from zbot.interfaces.spec import (
    PRIMITIVES,
    ActionSpec,
    Field,
    InterfaceSpec,
    MessageSpec,
    ServiceSpec,
    parts_of,
)
from zbot.names import KINDS

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from zbot.interfaces.message import Action, Message, Service

# Real messages have fewer levels. The limit protects the stack from a malicious definition.
MAX_NESTING = 60

_lock = threading.RLock()
_specs: dict[str, InterfaceSpec] = {}
_files: dict[str, str] = {}
_registered: list[str] = []  # names without a definition file
_classes: dict[str, type[Any]] = {}
_in_progress: list[str] = []


def renew_lock() -> None:
    """In a forked child, replace the lock, which a thread of the parent may hold."""
    global _lock  # noqa: PLW0603 - there is one per process
    _lock = threading.RLock()
    _in_progress.clear()


def get_spec(name: str) -> InterfaceSpec:
    """Return the spec with a name. `std_msgs/String` is short for `std_msgs/msg/String`.

    Parts have names too: `std_srvs/srv/SetBool_Request`, `pkg/action/Name_SendGoal`.

    Raises:
        UnknownPackageError: The package does not exist here. The error suggests similar names.
        UnknownInterfaceError: The package has no such interface. The error suggests similar names.
        InterfaceSyntaxError: The definition is wrong.
    """
    spec = find_spec(name)
    if spec is None:
        parts = name.split("/")
        raise _unknown(name, parts[0], parts[-1])
    return spec


def find_spec(name: str) -> InterfaceSpec | None:
    """Return the spec with a name, or None if there is no such spec.

    This is faster than `get_spec`, whose error has suggestions from all folders with packages.

    Raises:
        InterfaceSyntaxError: The definition is wrong.
    """
    with _lock:
        return _specs.get(name) or _known_spec(name)


def get_interface(name: str) -> type[Any]:
    """Return the class of a message, service or action. Raise the errors of `get_spec`."""
    cls = _classes.get(name)
    return cls if cls is not None else _get_class(get_spec(name))


def get_message(name: str) -> type[Message]:
    """Return the class of a message (`std_msgs/msg/String`). Raise the errors of `get_spec`."""
    cls: type[Message] = _of_kind(name, "msg", MessageSpec)
    return cls


def get_service(name: str) -> type[Service]:
    """Return the class of a service (`std_srvs/srv/SetBool`). Raise the errors of `get_spec`."""
    cls: type[Service] = _of_kind(name, "srv", ServiceSpec)
    return cls


def get_action(name: str) -> type[Action]:
    """Return the class of an action. Raise the errors of `get_spec`."""
    cls: type[Action] = _of_kind(name, "action", ActionSpec)
    return cls


def used_classes() -> list[type[Any]]:
    """Return the classes that this process has made or registered."""
    with _lock:
        return list(_classes.values())


def definition_text(name: str) -> str:
    """Return the text of a definition with its comments. Raise the errors of `get_spec`."""
    return get_spec(name).text


def packages() -> list[str]:
    """Return all packages with definitions, sorted."""
    return sorted(known_packages() | {name.partition("/")[0] for name in _registered})


def has_package(package: str) -> bool:
    """Return whether a package has definitions. This is faster than `packages()`."""
    if any(name.startswith(f"{package}/") for name in _registered):
        return True
    return package_folder(package) is not None


def is_loaded(name: str) -> bool:
    """Return whether the definition with a full name was read or registered."""
    return name in _specs


def interface_names(package: str) -> list[str]:
    """Return the full names of a package's interfaces, e.g. `pkg/msg/Name`, sorted.

    Raises:
        UnknownPackageError: The package does not exist here. The error suggests similar names.
    """
    names = {f"{package}/{file.parent.name}/{file.stem}" for file in interface_files(package)}
    names |= {name for name in _registered if name.startswith(f"{package}/")}
    if not names:
        raise UnknownPackageError(package, similar_names(package, packages(), 3))
    return sorted(names)


def register_spec(spec: InterfaceSpec) -> None:
    """Add a definition that no file here contains, e.g. a definition from another machine.

    Raises:
        WrongValueError: A different definition with the same name is known.
    """
    with _lock:
        known = find_spec(spec.name)
        if known is None:
            _add(spec, spec.name)
            _registered.append(spec.name)
        elif _layout(known) != _layout(spec):
            raise WrongValueError(
                f"{spec.name} is defined differently here: "
                "install the same definition on both machines"
            )


def register_class(spec: MessageSpec, cls: type[Any]) -> None:
    """Add a class of the program or of an installed ROS 2. It replaces a class of the same name."""
    with _lock:
        _add(spec, cls.__module__)
        _registered.append(spec.name)
        _classes[spec.name] = cls


def _of_kind(name: str, kind: str, spec_type: type[InterfaceSpec]) -> Any:
    package, slash, rest = name.partition("/")
    full = name if not slash or "/" in rest else f"{package}/{kind}/{rest}"
    spec = get_spec(full)
    if not isinstance(spec, spec_type):
        raise UnknownInterfaceError(f"{name} as a {kind}", (spec.name,))
    return get_interface(spec.name)


def _known_spec(name: str) -> InterfaceSpec | None:
    """Load and return the spec with a full or a short name, or None if there is no such spec."""
    parts = name.split("/")
    kinds = KINDS if len(parts) == 2 else (parts[1],) if len(parts) == 3 else ()
    for kind in kinds:
        full = f"{parts[0]}/{kind}/{parts[-1]}"
        if full not in _specs:
            _load(parts[0], kind, parts[-1].partition("_")[0])
        if full in _specs:
            return _specs[full]
    return None


def _load(package: str, kind: str, short: str) -> None:
    file = definition_file(package, kind, short) if kind in KINDS and short.isidentifier() else None
    if file is not None:
        # The parser is imported here, so that `import zbot` does not load it.
        from zbot.interfaces.parser import parse  # noqa: PLC0415

        _add(parse(f"{package}/{kind}/{short}", _text(file), str(file)), str(file))


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise InterfaceSyntaxError(str(file), 0, "", "the file is not UTF-8 text") from error


def _layout(spec: InterfaceSpec) -> tuple[Any, ...]:
    """Return the names and types of the fields. They must be equal on two machines."""
    if isinstance(spec, MessageSpec):
        return tuple((field.name, str(field.type)) for field in spec.fields)
    if isinstance(spec, ServiceSpec):
        return _layout(spec.request), _layout(spec.response)
    return _layout(spec.goal), _layout(spec.result), _layout(spec.feedback)


def _add(spec: InterfaceSpec, file: str) -> None:
    """Store a spec and the parts of a service or an action."""
    _specs[spec.name] = spec
    _files[spec.name] = file
    for part in parts_of(spec):
        _add(part, file)


def _unknown(name: str, package: str, short: str) -> UnknownPackageError | UnknownInterfaceError:
    if "/" not in name:
        known = [full for each in packages() for full in interface_names(each)]
        matching = tuple(full for full in known if full.endswith(f"/{name}"))[:3]
        return UnknownInterfaceError(name, matching)
    try:
        shorts = {full.rpartition("/")[2]: full for full in interface_names(package)}
    except UnknownPackageError as error:
        return error
    return UnknownInterfaceError(
        name, tuple(shorts[near] for near in similar_names(short, shorts, 3))
    )


def _get_class(spec: InterfaceSpec) -> type[Any]:
    with _lock:
        cls = _classes.get(spec.name)
        if cls is None:
            with _nesting_guarded(spec):
                cls = _classes[spec.name] = _make(spec)
        return cls


def _make(spec: InterfaceSpec) -> type[Any]:
    if isinstance(spec, MessageSpec):
        cls = make_message(spec, _nested_classes(spec))
        cls._REBUILD = rebuild_by_name, spec.name
        return cls
    if isinstance(spec, ServiceSpec):
        return make_service(spec, get_interface)
    return make_action(spec, get_interface)


def rebuild_by_name(name: str, values: tuple[Any, ...]) -> Message:
    """Return a message that was pickled. pickle calls this function."""
    cls = get_message(name)
    if hasattr(cls, "_SPEC"):
        return rebuild(cls, values)
    message = cls()  # the class of an installed ROS 2, which replaced zbot's class
    for field, value in zip(cls.get_fields_and_field_types(), values, strict=True):
        setattr(message, field, value)
    return message


def _nested_classes(spec: MessageSpec) -> dict[str, type[Any]]:
    """Return the class for each field that is a message. An error contains the field's line."""
    classes: dict[str, type[Any]] = {}
    for field in spec.fields:
        if field.type.is_message:
            try:
                classes[field.name] = get_interface(field.type.base)
            except (UnknownPackageError, UnknownInterfaceError, _NestingError) as error:
                file, source = _files[spec.name], _source_line(spec, field)
                raise InterfaceSyntaxError(
                    file, field.line, source, _reason(error, field)
                ) from error
    return classes


def _source_line(spec: MessageSpec, field: Field) -> str:
    """Return the line of the definition that declares a field."""
    lines = (line for line in spec.text.splitlines() if line.split()[1:2] == [field.name])
    return next(lines, f"{field.type.text} {field.name}")


def _reason(error: Exception, field: Field) -> str:
    """Return why a field's type cannot be used, and what to write if there is a type like it."""
    package, _, short = field.type.base.split("/")
    if not isinstance(error, UnknownInterfaceError):
        return str(error)
    if short.lower() in PRIMITIVES:
        right = [short.lower()]
    else:
        right = [f"{other}/{short}" for other in packages() if _has_message(other, short)][:3]
    return f"{package} has no message {short}: write {' or '.join(right)}" if right else str(error)


def _has_message(package: str, short: str) -> bool:
    return f"{package}/msg/{short}" in interface_names(package)


class _NestingError(Exception):
    """Messages contain themselves or are nested too deeply. The caller adds the file and line."""


@contextmanager
def _nesting_guarded(spec: InterfaceSpec) -> Iterator[None]:
    if spec.name in _in_progress:
        chain = " -> ".join((*_in_progress[_in_progress.index(spec.name) :], spec.name))
        raise _NestingError(f"a message cannot contain itself: {chain}")
    if len(_in_progress) >= MAX_NESTING:
        raise _NestingError(f"messages are nested deeper than {MAX_NESTING} levels")
    _in_progress.append(spec.name)
    try:
        yield
    finally:
        _in_progress.pop()


class LazyService:
    """Placeholder of a service class. The class is loaded when a part of it is first used.

    Args:
        name: Full name of a service, e.g. `rcl_interfaces/srv/GetParameters`.
    """

    def __init__(self, name: str) -> None:
        self._name = name

    @cached_property
    def Request(self) -> Any:  # noqa: N802 - as in a service class
        """The request class."""
        return cast("Any", get_service(self._name)).Request

    @cached_property
    def Response(self) -> Any:  # noqa: N802 - as in a service class
        """The response class."""
        return cast("Any", get_service(self._name)).Response
