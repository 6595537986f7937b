"""ROS 2's `interactive_markers`: markers that a user can move in RViz."""

from zbot.libraries.interactive_markers import InteractiveMarkerServer, MenuHandler
