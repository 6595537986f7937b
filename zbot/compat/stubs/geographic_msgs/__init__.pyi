# Written by python -m zbot.interfaces.stubs; do not edit.
from geographic_msgs import msg as msg
from geographic_msgs import srv as srv
