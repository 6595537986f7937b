# Written by python -m zbot.interfaces.stubs; do not edit.
from controller_manager_msgs import msg as msg
from controller_manager_msgs import srv as srv
