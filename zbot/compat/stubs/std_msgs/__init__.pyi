# Written by python -m zbot.interfaces.stubs; do not edit.
from std_msgs import msg as msg
