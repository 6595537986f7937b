"""The functions that ROS 2 has in a compiled module."""

from zbot.libraries.image_array import cvtColor2, cvtColorForDisplay, getCvType
