# Written by python -m zbot.interfaces.stubs; do not edit.
from foxglove_msgs import msg as msg
