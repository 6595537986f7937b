# Written by python -m zbot.interfaces.stubs; do not edit.
from ros_gz_interfaces import msg as msg
from ros_gz_interfaces import srv as srv
