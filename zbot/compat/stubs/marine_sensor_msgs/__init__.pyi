# Written by python -m zbot.interfaces.stubs; do not edit.
from marine_sensor_msgs import msg as msg
