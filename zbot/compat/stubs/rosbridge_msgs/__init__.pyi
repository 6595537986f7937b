# Written by python -m zbot.interfaces.stubs; do not edit.
from rosbridge_msgs import msg as msg
