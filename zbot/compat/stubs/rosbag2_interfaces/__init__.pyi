# Written by python -m zbot.interfaces.stubs; do not edit.
from rosbag2_interfaces import msg as msg
from rosbag2_interfaces import srv as srv
