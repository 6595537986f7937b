"""The types of fields."""

from zbot.interfaces.slot_type import AbstractGenericString as AbstractGenericString
from zbot.interfaces.slot_type import AbstractNestableType as AbstractNestableType
from zbot.interfaces.slot_type import AbstractNestedType as AbstractNestedType
from zbot.interfaces.slot_type import AbstractSequence as AbstractSequence
from zbot.interfaces.slot_type import AbstractString as AbstractString
from zbot.interfaces.slot_type import AbstractType as AbstractType
from zbot.interfaces.slot_type import AbstractWString as AbstractWString
from zbot.interfaces.slot_type import Array as Array
from zbot.interfaces.slot_type import BasicType as BasicType
from zbot.interfaces.slot_type import BoundedSequence as BoundedSequence
from zbot.interfaces.slot_type import BoundedString as BoundedString
from zbot.interfaces.slot_type import BoundedWString as BoundedWString
from zbot.interfaces.slot_type import NamedType as NamedType
from zbot.interfaces.slot_type import NamespacedType as NamespacedType
from zbot.interfaces.slot_type import UnboundedSequence as UnboundedSequence
from zbot.interfaces.slot_type import UnboundedString as UnboundedString
from zbot.interfaces.slot_type import UnboundedWString as UnboundedWString
