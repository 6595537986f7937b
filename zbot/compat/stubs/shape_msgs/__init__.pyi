# Written by python -m zbot.interfaces.stubs; do not edit.
from shape_msgs import msg as msg
