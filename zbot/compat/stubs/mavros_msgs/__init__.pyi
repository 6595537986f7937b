# Written by python -m zbot.interfaces.stubs; do not edit.
from mavros_msgs import msg as msg
from mavros_msgs import srv as srv
