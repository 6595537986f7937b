# Written by python -m zbot.interfaces.stubs; do not edit.
from velodyne_msgs import msg as msg
