"""Base class of all buffers."""

from zbot.tf2.buffer_interface import (
    BufferInterface,
    ConvertRegistration,
    TransformRegistration,
    convert,
)
from zbot.tf2.errors import NotImplementedException, TypeException
