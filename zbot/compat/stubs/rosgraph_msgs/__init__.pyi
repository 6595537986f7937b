# Written by python -m zbot.interfaces.stubs; do not edit.
from rosgraph_msgs import msg as msg
