# Written by python -m zbot.interfaces.stubs; do not edit.
from nav2_msgs import action as action
from nav2_msgs import msg as msg
from nav2_msgs import srv as srv
