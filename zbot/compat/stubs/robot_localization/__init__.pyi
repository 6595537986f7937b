# Written by python -m zbot.interfaces.stubs; do not edit.
from robot_localization import srv as srv
