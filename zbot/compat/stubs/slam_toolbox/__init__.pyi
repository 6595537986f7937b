# Written by python -m zbot.interfaces.stubs; do not edit.
from slam_toolbox import srv as srv
