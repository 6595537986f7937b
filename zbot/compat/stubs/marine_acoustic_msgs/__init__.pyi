# Written by python -m zbot.interfaces.stubs; do not edit.
from marine_acoustic_msgs import msg as msg
