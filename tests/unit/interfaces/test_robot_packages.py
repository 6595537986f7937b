"""Test of message packages outside of ROS 2's core that robot programs import."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.interfaces import get_interface


@pytest.mark.parametrize(
    ("name", "part", "field", "kind"),
    [
        ("nav2_msgs/action/NavigateToPose", "Goal", "pose", "geometry_msgs/PoseStamped"),
        ("nav2_msgs/action/NavigateToPose", "Feedback", "distance_remaining", "float"),
        ("nav2_msgs/action/FollowWaypoints", "Result", "missed_waypoints", "MissedWaypoint>"),
        ("nav2_msgs/srv/ManageLifecycleNodes", "Request", "command", "uint8"),
        ("nav2_msgs/action/AssistedTeleop", "Result", "error_code", "uint16"),
        ("nav2_msgs/action/ComputeAndTrackRoute", "Feedback", "route", "nav2_msgs/Route"),
        ("nav2_msgs/action/DockRobot", "Goal", "use_dock_id", "boolean"),
        ("nav2_msgs/action/FollowGPSWaypoints", "Goal", "gps_poses", "GeoPose>"),
        ("nav2_msgs/action/UndockRobot", "Goal", "max_undocking_time", "float"),
        ("nav2_msgs/srv/ClearCostmapAroundRobot", "Request", "reset_distance", "float"),
        ("nav2_msgs/srv/DynamicEdges", "Request", "adjust_edges", "EdgeCost>"),
        ("geographic_msgs/msg/GeoPoseStamped", "", "pose", "geographic_msgs/GeoPose"),
        ("control_msgs/action/FollowJointTrajectory", "Goal", "trajectory", "JointTrajectory"),
        ("control_msgs/action/GripperCommand", "Goal", "command", "control_msgs/GripperCommand"),
        ("vision_msgs/msg/Detection2D", "", "results", "ObjectHypothesisWithPose>"),
        ("ackermann_msgs/msg/AckermannDriveStamped", "", "drive", "AckermannDrive"),
    ],
)
def test_programs_for_robots_find_their_types(name: str, part: str, field: str, kind: str) -> None:
    made: Any = get_interface(name)
    types = (getattr(made, part) if part else made).get_fields_and_field_types()
    assert types[field].endswith(kind)
