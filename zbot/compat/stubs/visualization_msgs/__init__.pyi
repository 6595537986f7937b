# Written by python -m zbot.interfaces.stubs; do not edit.
from visualization_msgs import msg as msg
from visualization_msgs import srv as srv
