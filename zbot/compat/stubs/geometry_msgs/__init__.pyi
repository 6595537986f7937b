# Written by python -m zbot.interfaces.stubs; do not edit.
from geometry_msgs import msg as msg
