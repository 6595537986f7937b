# Written by python -m zbot.interfaces.stubs; do not edit.
from tf2_msgs import action as action
from tf2_msgs import msg as msg
from tf2_msgs import srv as srv
