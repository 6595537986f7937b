# Written by python -m zbot.interfaces.stubs; do not edit.
from type_description_interfaces import msg as msg
from type_description_interfaces import srv as srv
