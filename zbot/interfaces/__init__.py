"""Interface definitions of ROS 2, and the Python classes made from them."""

from typing import TYPE_CHECKING

from zbot.interfaces.finder import install_importer as install_importer
from zbot.lazy_imports import lazy_names

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

# Module of each name. A name is imported at its first use, because a command such as
# `zbot topic list` needs no definitions.
_MODULES = {
    "Action": "zbot.interfaces.message",
    "Message": "zbot.interfaces.message",
    "Service": "zbot.interfaces.message",
    "has_sequences": "zbot.interfaces.python_class",
    "message_spec_of": "zbot.interfaces.python_class",
    "spec_of": "zbot.interfaces.python_class",
    "type_description": "zbot.interfaces.python_class",
    "type_hash": "zbot.interfaces.python_class",
    "type_name": "zbot.interfaces.python_class",
    "definition_text": "zbot.interfaces.registry",
    "get_action": "zbot.interfaces.registry",
    "get_interface": "zbot.interfaces.registry",
    "get_message": "zbot.interfaces.registry",
    "get_service": "zbot.interfaces.registry",
    "get_spec": "zbot.interfaces.registry",
    "interface_names": "zbot.interfaces.registry",
    "packages": "zbot.interfaces.registry",
    "register_spec": "zbot.interfaces.registry",
    "register_description": "zbot.interfaces.remote_definition",
    "ActionSpec": "zbot.interfaces.spec",
    "Constant": "zbot.interfaces.spec",
    "Field": "zbot.interfaces.spec",
    "FieldType": "zbot.interfaces.spec",
    "InterfaceSpec": "zbot.interfaces.spec",
    "MessageSpec": "zbot.interfaces.spec",
    "ServiceSpec": "zbot.interfaces.spec",
}

__getattr__, __dir__ = lazy_names(__name__, _MODULES, "install_importer")
