# Written by python -m zbot.interfaces.stubs; do not edit.
from ackermann_msgs import msg as msg
