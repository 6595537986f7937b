# Written by python -m zbot.interfaces.stubs; do not edit.
from trajectory_msgs import msg as msg
