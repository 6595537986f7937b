# Written by python -m zbot.interfaces.stubs; do not edit.
from rosapi_msgs import msg as msg
from rosapi_msgs import srv as srv
