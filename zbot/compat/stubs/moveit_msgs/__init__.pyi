# Written by python -m zbot.interfaces.stubs; do not edit.
from moveit_msgs import action as action
from moveit_msgs import msg as msg
from moveit_msgs import srv as srv
