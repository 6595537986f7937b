# Written by python -m zbot.interfaces.stubs; do not edit.
from teleop_tools_msgs import action as action
