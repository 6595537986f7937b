# Written by python -m zbot.interfaces.stubs; do not edit.
from control_msgs import action as action
from control_msgs import msg as msg
from control_msgs import srv as srv
