# Written by python -m zbot.interfaces.stubs; do not edit.
from action_msgs import msg as msg
from action_msgs import srv as srv
