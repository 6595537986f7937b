# Written by python -m zbot.interfaces.stubs; do not edit.
from pcl_msgs import msg as msg
from pcl_msgs import srv as srv
