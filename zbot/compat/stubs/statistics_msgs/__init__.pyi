# Written by python -m zbot.interfaces.stubs; do not edit.
from statistics_msgs import msg as msg
