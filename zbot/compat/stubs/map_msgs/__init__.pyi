# Written by python -m zbot.interfaces.stubs; do not edit.
from map_msgs import msg as msg
from map_msgs import srv as srv
