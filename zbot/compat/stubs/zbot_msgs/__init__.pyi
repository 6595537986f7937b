# Written by python -m zbot.interfaces.stubs; do not edit.
from zbot_msgs import msg as msg
from zbot_msgs import srv as srv
