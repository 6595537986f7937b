# Written by python -m zbot.interfaces.stubs; do not edit.
from example_interfaces import action as action
from example_interfaces import msg as msg
from example_interfaces import srv as srv
