# Written by python -m zbot.interfaces.stubs; do not edit.
from radar_msgs import msg as msg
