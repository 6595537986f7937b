# Written by python -m zbot.interfaces.stubs; do not edit.
from lifecycle_msgs import msg as msg
from lifecycle_msgs import srv as srv
