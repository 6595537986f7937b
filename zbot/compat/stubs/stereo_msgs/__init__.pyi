# Written by python -m zbot.interfaces.stubs; do not edit.
from stereo_msgs import msg as msg
