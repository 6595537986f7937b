"""ROS 2 interface definitions, and the Python classes made from them."""

import importlib
from typing import TYPE_CHECKING, Any

from zbot.interfaces.finder import install_importer as install_importer

if TYPE_CHECKING:
    from zbot.interfaces.message import Action as Action
    from zbot.interfaces.message import Message as Message
    from zbot.interfaces.message import Service as Service
    from zbot.interfaces.python_class import has_sequences as has_sequences
    from zbot.interfaces.python_class import message_spec_of as message_spec_of
    from zbot.interfaces.python_class import spec_of as spec_of
    from zbot.interfaces.python_class import type_description as type_description
    from zbot.interfaces.python_class import type_hash as type_hash
    from zbot.interfaces.python_class import type_name as type_name
    from zbot.interfaces.registry import definition_text as definition_text
    from zbot.interfaces.registry import get_action as get_action
    from zbot.interfaces.registry import get_interface as get_interface
    from zbot.interfaces.registry import get_message as get_message
    from zbot.interfaces.registry import get_service as get_service
    from zbot.interfaces.registry import get_spec as get_spec
    from zbot.interfaces.registry import interface_names as interface_names
    from zbot.interfaces.registry import packages as packages
    from zbot.interfaces.registry import register_spec as register_spec
    from zbot.interfaces.remote_definition import register_description as register_description
    from zbot.interfaces.spec import ActionSpec as ActionSpec
    from zbot.interfaces.spec import Constant as Constant
    from zbot.interfaces.spec import Field as Field
    from zbot.interfaces.spec import FieldType as FieldType
    from zbot.interfaces.spec import InterfaceSpec as InterfaceSpec
    from zbot.interfaces.spec import MessageSpec as MessageSpec
    from zbot.interfaces.spec import ServiceSpec as ServiceSpec

# Where each name lives: it is imported when it is first used, because a command that lists topics
# needs no definitions.
_HOMES = {
    "Action": "message",
    "Message": "message",
    "Service": "message",
    "has_sequences": "python_class",
    "message_spec_of": "python_class",
    "spec_of": "python_class",
    "type_description": "python_class",
    "type_hash": "python_class",
    "type_name": "python_class",
    "definition_text": "registry",
    "get_action": "registry",
    "get_interface": "registry",
    "get_message": "registry",
    "get_service": "registry",
    "get_spec": "registry",
    "interface_names": "registry",
    "packages": "registry",
    "register_spec": "registry",
    "register_description": "remote_definition",
    "ActionSpec": "spec",
    "Constant": "spec",
    "Field": "spec",
    "FieldType": "spec",
    "InterfaceSpec": "spec",
    "MessageSpec": "spec",
    "ServiceSpec": "spec",
}


def __getattr__(name: str) -> Any:
    """Import a public name from its module."""
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module 'zbot.interfaces' has no attribute {name!r}")
    value = globals()[name] = getattr(importlib.import_module(f"zbot.interfaces.{home}"), name)
    return value


def __dir__() -> list[str]:
    """Return what can be imported from here."""
    return sorted((*_HOMES, "install_importer"))
