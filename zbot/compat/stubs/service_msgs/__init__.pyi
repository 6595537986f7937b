# Written by python -m zbot.interfaces.stubs; do not edit.
from service_msgs import msg as msg
