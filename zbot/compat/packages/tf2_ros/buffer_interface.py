"""What buffers have in common."""

from zbot.tf2.buffer import Buffer as BufferInterface
from zbot.tf2.conversion import add as add
from zbot.tf2.errors import NotImplementedException as NotImplementedException
from zbot.tf2.errors import TypeException as TypeException
