# Written by python -m zbot.interfaces.stubs; do not edit.
from composition_interfaces import srv as srv
