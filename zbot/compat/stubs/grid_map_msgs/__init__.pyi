# Written by python -m zbot.interfaces.stubs; do not edit.
from grid_map_msgs import msg as msg
from grid_map_msgs import srv as srv
