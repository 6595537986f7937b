"""Test of message packages outside of ROS 2's core that robot programs import."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import pytest

from zbot.interfaces import (
    MessageSpec,
    ServiceSpec,
    get_interface,
    get_spec,
    interface_names,
    type_hash,
)

#: Packages whose facts were compared with the definitions of their authors, and the versions.
COMPARED = json.loads((Path(__file__).parent / "data" / "robot_packages.json").read_text())


@pytest.mark.parametrize(
    ("name", "part", "field", "kind"),
    [
        ("nav2_msgs/action/NavigateToPose", "Goal", "pose", "geometry_msgs/PoseStamped"),
        ("nav2_msgs/action/NavigateToPose", "Feedback", "distance_remaining", "float"),
        ("nav2_msgs/action/FollowWaypoints", "Result", "missed_waypoints", "WaypointStatus>"),
        ("nav2_msgs/srv/ManageLifecycleNodes", "Request", "command", "uint8"),
        ("nav2_msgs/action/AssistedTeleop", "Result", "error_code", "uint16"),
        ("nav2_msgs/action/ComputeAndTrackRoute", "Feedback", "route", "nav2_msgs/Route"),
        ("nav2_msgs/action/DockRobot", "Goal", "use_dock_id", "boolean"),
        ("nav2_msgs/action/FollowGPSWaypoints", "Goal", "gps_poses", "GeoPose>"),
        ("nav2_msgs/action/UndockRobot", "Goal", "max_undocking_time", "float"),
        ("nav2_msgs/srv/ClearCostmapAroundRobot", "Request", "reset_distance", "float"),
        ("nav2_msgs/srv/DynamicEdges", "Request", "adjust_edges", "EdgeCost>"),
        ("ros_gz_interfaces/srv/SpawnEntity", "Request", "entity_factory", "EntityFactory"),
        ("simulation_interfaces/srv/SpawnEntity", "Response", "result", "Result"),
        ("gazebo_msgs/srv/SpawnEntity", "Request", "robot_namespace", "string"),
        ("gps_msgs/msg/GPSFix", "", "status", "gps_msgs/GPSStatus"),
        ("pcl_msgs/msg/PointIndices", "", "indices", "sequence<int32>"),
        ("grid_map_msgs/msg/GridMap", "", "data", "Float32MultiArray>"),
        ("can_msgs/msg/Frame", "", "data", "uint8[8]"),
        ("bond/msg/Status", "", "instance_id", "string"),
        ("velodyne_msgs/msg/VelodyneScan", "", "packets", "VelodynePacket>"),
        ("mavros_msgs/srv/CommandBool", "Request", "value", "boolean"),
        ("marine_acoustic_msgs/msg/Dvl", "", "beam_velocities_valid", "boolean"),
        ("slam_toolbox/srv/SaveMap", "Request", "name", "std_msgs/String"),
        ("geographic_msgs/msg/GeoPoseStamped", "", "pose", "geographic_msgs/GeoPose"),
        ("control_msgs/action/FollowJointTrajectory", "Goal", "trajectory", "JointTrajectory"),
        ("control_msgs/action/GripperCommand", "Goal", "command", "control_msgs/GripperCommand"),
        ("vision_msgs/msg/Detection2D", "", "results", "ObjectHypothesisWithPose>"),
        ("ackermann_msgs/msg/AckermannDriveStamped", "", "drive", "AckermannDrive"),
        ("control_msgs/msg/PidState", "", "i_term", "double"),
        ("controller_manager_msgs/srv/ListControllers", "Response", "controller", "State>"),
        ("rosapi_msgs/srv/GetParam", "Response", "successful", "boolean"),
        ("rosbridge_msgs/msg/ConnectedClients", "", "clients", "ConnectedClient>"),
        ("moveit_msgs/action/MoveGroup", "Result", "error_code", "moveit_msgs/MoveItErrorCodes"),
        ("moveit_msgs/msg/CollisionObject", "", "operation", "octet"),
        ("map_msgs/msg/OccupancyGridUpdate", "", "data", "sequence<int8>"),
        ("nmea_msgs/msg/Sentence", "", "sentence", "string"),
        ("irobot_create_msgs/action/Dock", "Result", "is_docked", "boolean"),
        ("turtlebot3_msgs/msg/SensorState", "", "left_encoder", "int32"),
        ("robot_localization/srv/GetState", "Response", "covariance", "double[225]"),
        ("foxglove_msgs/msg/SceneUpdate", "", "entities", "SceneEntity>"),
        ("apriltag_msgs/msg/AprilTagDetection", "", "corners", "apriltag_msgs/Point[4]"),
        ("radar_msgs/msg/RadarTrack", "", "uuid", "unique_identifier_msgs/UUID"),
    ],
)
def test_programs_for_robots_find_their_types(name: str, part: str, field: str, kind: str) -> None:
    made: Any = get_interface(name)
    types = (getattr(made, part) if part else made).get_fields_and_field_types()
    assert types[field].endswith(kind)


@pytest.mark.parametrize("package", COMPARED)
def test_names_types_constants_and_order_are_those_that_were_compared(package: str) -> None:
    # No hash covers constants and defaults, and a wrong definition only shows between machines.
    digest = hashlib.sha256("\n".join(facts(package)).encode()).hexdigest()
    assert digest == COMPARED[package]["facts"]


@pytest.mark.parametrize("package", COMPARED)
def test_every_type_has_a_class_and_a_hash(package: str) -> None:
    for name in interface_names(package):
        assert get_interface(name)
        assert type_hash(name).startswith("RIHS01_")


def facts(package: str) -> list[str]:
    lines = []
    for name in interface_names(package):
        for message in messages(name):
            lines.append(message.name)
            lines += [
                f"{field.type.text} {field.name} {field.default!r}" for field in message.fields
            ]
            lines += [
                f"{constant.type.text} {constant.name}={constant.value!r}"
                for constant in message.constants
            ]
    return lines


def messages(name: str) -> list[MessageSpec]:
    spec = get_spec(name)
    if isinstance(spec, MessageSpec):
        return [spec]
    if isinstance(spec, ServiceSpec):
        return [spec.request, spec.response]
    return [spec.goal, spec.result, spec.feedback]
