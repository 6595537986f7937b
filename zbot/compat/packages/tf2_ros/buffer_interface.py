"""What buffers have in common."""

from zbot.tf2.buffer_interface import BufferInterface as BufferInterface
from zbot.tf2.buffer_interface import ConvertRegistration as ConvertRegistration
from zbot.tf2.buffer_interface import TransformRegistration as TransformRegistration
from zbot.tf2.buffer_interface import convert as convert
from zbot.tf2.errors import NotImplementedException as NotImplementedException
from zbot.tf2.errors import TypeException as TypeException
