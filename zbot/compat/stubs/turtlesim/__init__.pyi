# Written by python -m zbot.interfaces.stubs; do not edit.
from turtlesim import action as action
from turtlesim import msg as msg
from turtlesim import srv as srv
