# Written by python -m zbot.interfaces.stubs; do not edit.
from test_msgs import action as action
from test_msgs import msg as msg
from test_msgs import srv as srv
