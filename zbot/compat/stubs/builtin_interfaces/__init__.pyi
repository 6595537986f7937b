# Written by python -m zbot.interfaces.stubs; do not edit.
from builtin_interfaces import msg as msg
