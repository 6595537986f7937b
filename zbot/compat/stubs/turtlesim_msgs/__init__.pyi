# Written by python -m zbot.interfaces.stubs; do not edit.
from turtlesim_msgs import action as action
from turtlesim_msgs import msg as msg
from turtlesim_msgs import srv as srv
