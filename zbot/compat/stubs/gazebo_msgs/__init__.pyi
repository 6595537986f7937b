# Written by python -m zbot.interfaces.stubs; do not edit.
from gazebo_msgs import msg as msg
from gazebo_msgs import srv as srv
