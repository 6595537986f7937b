# Written by python -m zbot.interfaces.stubs; do not edit.
from nmea_msgs import msg as msg
