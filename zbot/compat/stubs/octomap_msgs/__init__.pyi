# Written by python -m zbot.interfaces.stubs; do not edit.
from octomap_msgs import msg as msg
from octomap_msgs import srv as srv
