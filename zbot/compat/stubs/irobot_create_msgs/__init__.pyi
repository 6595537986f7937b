# Written by python -m zbot.interfaces.stubs; do not edit.
from irobot_create_msgs import action as action
from irobot_create_msgs import msg as msg
from irobot_create_msgs import srv as srv
