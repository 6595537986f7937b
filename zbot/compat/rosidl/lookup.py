"""Look-up of interfaces by name and by package, as in `rosidl_runtime_py`."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

from zbot.errors import WrongValueError
from zbot.interfaces import registry
from zbot.interfaces.errors import UnknownInterfaceError, UnknownPackageError
from zbot.interfaces.location import interface_files, package_folder
from zbot.names import KINDS
from zbot.package import package_prefix

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.interfaces import Action, Message, Service
    from zbot.interfaces.slot_type import AbstractNestedType, NamespacedType


def interface_name_error(wanted: str, name: str) -> WrongValueError:
    """Return the error that a name has the wrong form, or names another kind of interface."""
    return WrongValueError(f"Expected the full name of {wanted}, got '{name}'")


def get_interface(identifier: str) -> type[Any]:
    """Return the class of a message, a service or an action, e.g. `std_msgs/msg/String`.

    Raises:
        WrongValueError: The name does not have 3 parts, or the second is not msg, srv or action.
        UnknownPackageError: The package does not exist. The error is also a ModuleNotFoundError.
        UnknownInterfaceError: The package has no such interface. The error is also an
            AttributeError.
    """
    parts = identifier.split("/")
    if len(parts) != 3 or not all(parts) or parts[1] not in KINDS:
        raise interface_name_error("an interface", identifier)
    return registry.get_interface(identifier)


def get_message(identifier: str) -> type[Message]:
    """Return the class of a message, e.g. `std_msgs/msg/String` or `std_msgs/String`.

    The function raises the errors of `get_interface`.
    """
    cls: type[Message] = _of_kind(identifier, "msg", "a message")
    return cls


def get_service(identifier: str) -> type[Service]:
    """Return the class of a service. The rules are those of `get_message`."""
    cls: type[Service] = _of_kind(identifier, "srv", "a service")
    return cls


def get_action(identifier: str) -> type[Action]:
    """Return the class of an action. The rules are those of `get_message`."""
    cls: type[Action] = _of_kind(identifier, "action", "an action")
    return cls


def _of_kind(identifier: str, kind: str, wanted: str) -> Any:
    parts = identifier.split("/")
    if len(parts) == 2:
        parts.insert(1, kind)
    if len(parts) != 3 or not all(parts) or parts[1] not in KINDS:
        raise interface_name_error(wanted, identifier)
    cls = registry.get_interface("/".join(parts))
    if not _CHECKS[kind](cls):
        raise interface_name_error(wanted, identifier)
    return cls


def is_message(interface: type[Any]) -> bool:
    """Return whether a class is a message class."""
    return hasattr(interface, "get_fields_and_field_types")


def is_service(interface: type[Any]) -> bool:
    """Return whether a class is a service class."""
    return hasattr(interface, "Request") and hasattr(interface, "Response")


def is_action(interface: type[Any]) -> bool:
    """Return whether a class is an action class."""
    return all(hasattr(interface, part) for part in ("Goal", "Result", "Feedback"))


_CHECKS = {"msg": is_message, "srv": is_service, "action": is_action}


def import_message_from_namespaced_type(
    message_type: NamespacedType | AbstractNestedType,
) -> type[Message]:
    """Return the message class of an entry of `SLOT_TYPES`.

    For an array or a sequence, warn and return the class of the elements.
    """
    inner: Any = message_type
    if hasattr(inner, "value_type"):
        text = "give the value_type of an array or sequence, not the array itself"
        warnings.warn(text, DeprecationWarning, stacklevel=2)
        inner = inner.value_type
    cls: type[Message] = registry.get_interface("/".join((*inner.namespaces, inner.name)))
    return cls


def get_interface_packages() -> list[str]:
    """Return all packages with messages, services or actions."""
    return registry.packages()


def get_interfaces(
    package_names: Iterable[str] = (), *, kinds: Iterable[str] = KINDS
) -> dict[str, list[str]]:
    """Return the interfaces of the given packages or of all packages, e.g. `{'a': ['srv/B']}`.

    Packages without interfaces are not in the result.

    Raises:
        LookupError: A package does not exist.
    """
    wanted = list(package_names) or registry.packages()
    found = {package: _names(package, tuple(kinds)) for package in wanted}
    return {package: names for package, names in found.items() if names}


def get_message_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the messages of packages: `{'std_msgs': ['msg/Bool', ...]}`. See `get_interfaces`."""
    return get_interfaces(package_names, kinds=["msg"])


def get_service_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the services of packages. See `get_interfaces`."""
    return get_interfaces(package_names, kinds=["srv"])


def get_action_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the actions of packages. See `get_interfaces`."""
    return get_interfaces(package_names, kinds=["action"])


def get_interface_path(interface_name: str) -> str:
    """Return the file that defines an interface, e.g. `std_msgs/msg/String` (`.msg` is optional).

    Raises:
        WrongValueError: The name does not have three parts.
        LookupError: The package or the file does not exist.
    """
    parts = interface_name.split("/")
    if len(parts) != 3 or not all(parts):
        raise interface_name_error("an interface", interface_name)
    package, kind, short = parts
    folder = package_folder(package)
    if folder is None:
        raise UnknownPackageError(package)
    files = {file.name: file for file in interface_files(package) if file.parent.name == kind}
    file = files.get(short) or files.get(f"{short}.{kind}")
    if file is None:
        raise UnknownInterfaceError(interface_name)
    return str(file)


def _names(package: str, kinds: tuple[str, ...]) -> list[str]:
    try:
        names = registry.interface_names(package)
    except UnknownPackageError:
        package_prefix(package)  # raises an error if the package does not exist
        return []
    short = [name.partition("/")[2] for name in names]
    return [name for name in short if name.partition("/")[0] in kinds]
