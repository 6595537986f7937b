# Written by python -m zbot.interfaces.stubs; do not edit.
from rcl_interfaces import msg as msg
from rcl_interfaces import srv as srv
