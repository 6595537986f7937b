# Written by python -m zbot.interfaces.stubs; do not edit.
from topic_tools_interfaces import srv as srv
