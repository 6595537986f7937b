"""Names that the node with sliders for joints shares with the panel that shows the sliders."""

from __future__ import annotations

#: The parameter of a joint is this and the name of the joint.
PREFIX = "joints."
#: Descriptions of these parameters.
ANGLE, DISTANCE = "position in rad", "position in m"
#: Services in the namespace of the node, which move all joints.
CENTER, RANDOMIZE = "center", "randomize"
EMPTY_TYPE = "std_srvs/srv/Empty"
