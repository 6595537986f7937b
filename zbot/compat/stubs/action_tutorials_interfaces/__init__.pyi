# Written by python -m zbot.interfaces.stubs; do not edit.
from action_tutorials_interfaces import action as action
