# Written by python -m zbot.interfaces.stubs; do not edit.
from apriltag_msgs import msg as msg
