# Written by python -m zbot.interfaces.stubs; do not edit.
from unique_identifier_msgs import msg as msg
