"""Interface definitions of ROS 2, and the Python classes made from them."""

from typing import TYPE_CHECKING

from zbot.interfaces.finder import install_importer as install_importer
from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from zbot.interfaces.message import Action as Action
    from zbot.interfaces.message import Message as Message
    from zbot.interfaces.message import Service as Service
    from zbot.interfaces.python_class import has_byte_sequences as has_byte_sequences
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

# The public names of each module. A name is imported at its first use, because a command such as
# `zbot topic list` needs no definitions.
_MODULES = {
    "zbot.interfaces.message": "Action Message Service",
    "zbot.interfaces.python_class": (
        "has_byte_sequences has_sequences message_spec_of spec_of type_description type_hash "
        "type_name"
    ),
    "zbot.interfaces.registry": (
        "definition_text get_action get_interface get_message get_service get_spec "
        "interface_names packages register_spec"
    ),
    "zbot.interfaces.remote_definition": "register_description",
    "zbot.interfaces.spec": (
        "ActionSpec Constant Field FieldType InterfaceSpec MessageSpec ServiceSpec"
    ),
}

__getattr__, __dir__ = lazy_names(__name__, _MODULES, "install_importer")
