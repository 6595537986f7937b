# Written by python -m zbot.interfaces.stubs; do not edit.
from actionlib_msgs import msg as msg
