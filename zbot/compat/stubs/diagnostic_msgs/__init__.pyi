# Written by python -m zbot.interfaces.stubs; do not edit.
from diagnostic_msgs import msg as msg
from diagnostic_msgs import srv as srv
