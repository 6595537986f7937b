# Written by python -m zbot.interfaces.stubs; do not edit.
from can_msgs import msg as msg
