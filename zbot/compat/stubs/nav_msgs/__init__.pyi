# Written by python -m zbot.interfaces.stubs; do not edit.
from nav_msgs import msg as msg
from nav_msgs import srv as srv
