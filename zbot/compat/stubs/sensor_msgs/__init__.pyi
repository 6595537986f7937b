# Written by python -m zbot.interfaces.stubs; do not edit.
from sensor_msgs import msg as msg
from sensor_msgs import srv as srv
