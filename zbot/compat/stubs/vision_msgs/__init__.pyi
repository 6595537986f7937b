# Written by python -m zbot.interfaces.stubs; do not edit.
from vision_msgs import msg as msg
