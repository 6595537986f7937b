# Written by python -m zbot.interfaces.stubs; do not edit.
from object_recognition_msgs import action as action
from object_recognition_msgs import msg as msg
from object_recognition_msgs import srv as srv
