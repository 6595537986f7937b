# Written by python -m zbot.interfaces.stubs; do not edit.
from turtlebot3_msgs import action as action
from turtlebot3_msgs import msg as msg
from turtlebot3_msgs import srv as srv
