"""Interfaces by name: their definitions are found, read and made into classes at first use."""

from __future__ import annotations

import threading
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from zbot.errors import close_matches
from zbot.interfaces.classes import make_action, make_message, make_service
from zbot.interfaces.errors import (
    InterfaceConflictError,
    InterfaceSyntaxError,
    UnknownInterfaceError,
    UnknownPackageError,
)
from zbot.interfaces.kinds import KINDS
from zbot.interfaces.location import (
    definition_file,
    interface_files,
    known_packages,
    package_folder,
)
from zbot.interfaces.spec import (
    ActionSpec,
    InterfaceSpec,
    MessageSpec,
    ServiceSpec,
    parts_of,
)

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from zbot.interfaces.message import Action, Message, Service

# Deeper than any real message; keeps a hostile definition from exhausting the stack.
_MAX_NESTING = 60

_lock = threading.RLock()
_specs: dict[str, InterfaceSpec] = {}
_files: dict[str, str] = {}
_registered: list[str] = []  # what no file defines
_classes: dict[str, type[Any]] = {}
_being_made: list[str] = []


def get_spec(name: str) -> InterfaceSpec:
    """Look up a definition; `std_msgs/String` is short for `std_msgs/msg/String`.

    Parts have names too: `std_srvs/srv/SetBool_Request`, `pkg/action/Name_SendGoal`.

    Raises:
        UnknownPackageError: No such package here; has suggestions.
        UnknownInterfaceError: The package has no such interface; has suggestions.
        InterfaceSyntaxError: Its definition is wrong.
    """
    with _lock:
        spec = _specs.get(name)
        return spec if spec is not None else _found(name)


def get_interface(name: str) -> type[Any]:
    """Look up the class of a message, a service or an action; raises what `get_spec` raises."""
    cls = _classes.get(name)
    return cls if cls is not None else _made(get_spec(name))


def get_message(name: str) -> type[Message]:
    """Look up the class of a message, e.g. `std_msgs/msg/String`; raises what `get_spec` raises."""
    cls: type[Message] = _of_kind(name, "msg", MessageSpec)
    return cls


def get_service(name: str) -> type[Service]:
    """Look up the class of a service, `std_srvs/srv/SetBool`; raises what `get_spec` raises."""
    cls: type[Service] = _of_kind(name, "srv", ServiceSpec)
    return cls


def get_action(name: str) -> type[Action]:
    """Look up the class of an action; raises what `get_spec` raises."""
    cls: type[Action] = _of_kind(name, "action", ActionSpec)
    return cls


def definition_text(name: str) -> str:
    """The text of a definition, comments and all; raises what `get_spec` raises."""
    return get_spec(name).text


def packages() -> list[str]:
    """Every package with definitions, sorted."""
    return sorted(known_packages() | {name.partition("/")[0] for name in _registered})


def has_package(package: str) -> bool:
    """Whether a package has definitions; without listing all of them."""
    if any(name.startswith(f"{package}/") for name in _registered):
        return True
    return package_folder(package) is not None


def interface_names(package: str) -> list[str]:
    """The interfaces of a package, `pkg/action/Name`, `pkg/msg/Name`, `pkg/srv/Name`, sorted.

    Raises:
        UnknownPackageError: No such package here; has suggestions.
    """
    names = {f"{package}/{file.parent.name}/{file.stem}" for file in interface_files(package)}
    names |= {name for name in _registered if name.startswith(f"{package}/")}
    if not names:
        raise UnknownPackageError(package, close_matches(package, packages()))
    return sorted(names)


def register_spec(spec: InterfaceSpec) -> None:
    """Make a definition known that no file here has, e.g. one that another machine sent.

    Raises:
        InterfaceConflictError: Another definition of that name is known.
    """
    with _lock:
        try:
            known = get_spec(spec.name)
        except (UnknownPackageError, UnknownInterfaceError):
            _add(spec, spec.name)
            _registered.append(spec.name)
        else:
            if _layout(known) != _layout(spec):
                raise InterfaceConflictError(spec.name)


def register_class(spec: MessageSpec, cls: type[Any]) -> None:
    """Make a class of the user's, or of a real ROS 2, that of its name; the last one wins."""
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


def _found(name: str) -> InterfaceSpec:
    """The spec of a name that is not loaded yet, or known in full only."""
    parts = name.split("/")
    kinds = KINDS if len(parts) == 2 else (parts[1],) if len(parts) == 3 else ()
    for kind in kinds:
        full = f"{parts[0]}/{kind}/{parts[-1]}"
        if full not in _specs:
            _load(parts[0], kind, parts[-1].partition("_")[0])
        if full in _specs:
            return _specs[full]
    raise _unknown(name, parts[0], parts[-1])


def _load(package: str, kind: str, short: str) -> None:
    file = definition_file(package, kind, short) if kind in KINDS and short.isidentifier() else None
    if file is not None:
        # Importing zbot reads no definition, so it need not load what does.
        from zbot.interfaces.parser import parse  # noqa: PLC0415

        _add(parse(f"{package}/{kind}/{short}", _text(file), str(file)), str(file))


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise InterfaceSyntaxError(str(file), 0, "", "the file is not UTF-8 text") from error


def _layout(spec: InterfaceSpec) -> tuple[Any, ...]:
    """What two machines must agree on: names and types of the fields, not defaults or constants."""
    if isinstance(spec, MessageSpec):
        return tuple((field.name, str(field.type)) for field in spec.fields)
    if isinstance(spec, ServiceSpec):
        return _layout(spec.request), _layout(spec.response)
    return _layout(spec.goal), _layout(spec.result), _layout(spec.feedback)


def _add(spec: InterfaceSpec, file: str) -> None:
    """Make a spec known, with the parts of a service or an action."""
    _specs[spec.name] = spec
    _files[spec.name] = file
    for part in parts_of(spec):
        _add(part, file)


def _unknown(name: str, package: str, short: str) -> UnknownPackageError | UnknownInterfaceError:
    if "/" not in name:
        near = [full for each in packages() for full in interface_names(each)]
        matching = tuple(full for full in near if full.endswith(f"/{name}"))[:3]
        return UnknownInterfaceError(name, matching)
    try:
        shorts = {full.rpartition("/")[2]: full for full in interface_names(package)}
    except UnknownPackageError as error:
        return error
    return UnknownInterfaceError(name, tuple(shorts[near] for near in close_matches(short, shorts)))


def _made(spec: InterfaceSpec) -> type[Any]:
    with _lock:
        cls = _classes.get(spec.name)
        if cls is None:
            with _nesting_guarded(spec):
                cls = _classes[spec.name] = _make(spec)
        return cls


def _make(spec: InterfaceSpec) -> type[Any]:
    if isinstance(spec, MessageSpec):
        return make_message(spec, _nested_classes(spec))
    if isinstance(spec, ServiceSpec):
        return make_service(spec, get_interface)
    return make_action(spec, get_interface)


def _nested_classes(spec: MessageSpec) -> dict[str, type[Any]]:
    """The class for each field that is a message; an error names the field's line."""
    classes: dict[str, type[Any]] = {}
    for field in spec.fields:
        if field.type.is_message:
            try:
                classes[field.name] = get_interface(field.type.base)
            except (UnknownPackageError, UnknownInterfaceError, _NestingError) as error:
                source = f"{field.type.text} {field.name}"
                file = _files[spec.name]
                raise InterfaceSyntaxError(file, field.line, source, str(error)) from error
    return classes


class _NestingError(Exception):
    """Messages inside messages without an end; the caller adds file and line."""


@contextmanager
def _nesting_guarded(spec: InterfaceSpec) -> Iterator[None]:
    if spec.name in _being_made:
        chain = " -> ".join((*_being_made[_being_made.index(spec.name) :], spec.name))
        raise _NestingError(f"a message cannot contain itself: {chain}")
    if len(_being_made) >= _MAX_NESTING:
        raise _NestingError(f"messages are nested deeper than {_MAX_NESTING} levels")
    _being_made.append(spec.name)
    try:
        yield
    finally:
        _being_made.pop()
