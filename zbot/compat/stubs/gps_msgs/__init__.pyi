# Written by python -m zbot.interfaces.stubs; do not edit.
from gps_msgs import msg as msg
