"""Table of the ROS 2 packages whose programs zbot replaces by its own nodes (bundled nodes)."""

from __future__ import annotations

from typing import Final

_DEMO_NODES = {
    name: name for name in ("add_two_ints_client", "add_two_ints_server", "listener", "talker")
}
_FIBONACCI = {name: name for name in ("fibonacci_action_client", "fibonacci_action_server")}
_LIFECYCLE = {"lifecycle_talker": "lifecycle_talker"}

_RQT = (
    *("rqt_action", "rqt_console", "rqt_graph", "rqt_gui", "rqt_image_view", "rqt_logger_level"),
    *("rqt_msg", "rqt_plot", "rqt_publisher", "rqt_reconfigure", "rqt_service_caller", "rqt_top"),
    "rqt_topic",
)
#: Programs on the PATH of a ROS 2 installation that bundled nodes replace: name -> package.
BUNDLED_PROGRAMS: Final[dict[str, str]] = {
    "rqt": "rqt_gui",
    **{name: name for name in (*_RQT, "xacro")},
}

#: For the name of each ROS 2 package: its executables, and their modules in `zbot_nodes`.
BUNDLED_NODES: Final[dict[str, dict[str, str]]] = {
    "action_tutorials_cpp": _FIBONACCI,
    "action_tutorials_py": _FIBONACCI,
    "controller_manager": {
        "hardware_spawner": "control.hardware_spawner",
        "ros2_control_node": "control.controller_manager",
        "spawner": "control.spawner",
        "spawner.py": "control.spawner",
        "unspawner": "control.unspawner",
    },
    "demo_nodes_cpp": {**_DEMO_NODES, "parameter_blackboard": "parameter_blackboard"},
    "demo_nodes_py": _DEMO_NODES,
    "joy": {"joy_node": "driving.joy_node"},
    "joy_linux": {"joy_linux_node": "driving.joy_linux_node"},
    "joy_teleop": {"joy_teleop": "driving.joy_teleop"},
    "lifecycle": _LIFECYCLE,
    "lifecycle_py": _LIFECYCLE,
    "diagnostic_aggregator": {"aggregator_node": "diagnostics.aggregator_node"},
    "image_transport": {"republish": "images.republish"},
    "joint_state_publisher": {"joint_state_publisher": "description.joint_state_publisher"},
    "joint_state_publisher_gui": {
        "joint_state_publisher_gui": "description.joint_state_publisher_gui"
    },
    "nav2_lifecycle_manager": {"lifecycle_manager": "navigation.lifecycle_manager"},
    "nav2_map_server": {
        "map_saver_cli": "navigation.map_saver_cli",
        "map_saver_server": "navigation.map_saver_server",
        "map_server": "navigation.map_server",
    },
    "robot_state_publisher": {"robot_state_publisher": "description.robot_state_publisher"},
    "teleop_twist_joy": {"teleop_node": "driving.teleop_twist_joy"},
    **{name: {name: "page.rqt"} for name in _RQT},
    "ros2_controllers_test_nodes": {
        "publisher_forward_position_controller": "control.forward_position_publisher",
        "publisher_joint_trajectory_controller": "control.joint_trajectory_publisher",
    },
    "rqt_gui": {"rqt_gui": "page.rqt", "rqt": "page.rqt"},
    "tf2_ros": {
        "static_transform_publisher": "static_transform_publisher",
        "tf2_echo": "tf2_echo",
        "tf2_monitor": "frames.tf2_monitor",
    },
    "tf2_tools": {"view_frames": "frames.view_frames"},
    "topic_tools": {
        name: f"topics.{name}" for name in ("delay", "drop", "mux", "relay", "throttle")
    },
    "turtlesim": {
        "draw_square": "draw_square",
        "mimic": "mimic",
        "turtle_teleop_key": "turtle_teleop_key",
        "turtlesim_node": "turtlesim_node",
    },
    "twist_mux": {"twist_mux": "driving.twist_mux"},
    "urdf_launch": {},  # only launch files
    "xacro": {"xacro": "description.xacro_program"},
}

#: Components (plugins of C++ libraries) that bundled nodes replace: plugin -> package, executable.
BUNDLED_COMPONENTS: Final[dict[str, tuple[str, str]]] = {
    "action_tutorials_cpp::FibonacciActionClient": (
        "action_tutorials_cpp",
        "fibonacci_action_client",
    ),
    "action_tutorials_cpp::FibonacciActionServer": (
        "action_tutorials_cpp",
        "fibonacci_action_server",
    ),
    "composition::Client": ("demo_nodes_cpp", "add_two_ints_client"),
    "composition::Listener": ("demo_nodes_cpp", "listener"),
    "composition::Server": ("demo_nodes_cpp", "add_two_ints_server"),
    "composition::Talker": ("demo_nodes_cpp", "talker"),
    "demo_nodes_cpp::ClientNode": ("demo_nodes_cpp", "add_two_ints_client"),
    "demo_nodes_cpp::Listener": ("demo_nodes_cpp", "listener"),
    "demo_nodes_cpp::ParameterBlackboard": ("demo_nodes_cpp", "parameter_blackboard"),
    "demo_nodes_cpp::ServerNode": ("demo_nodes_cpp", "add_two_ints_server"),
    "demo_nodes_cpp::Talker": ("demo_nodes_cpp", "talker"),
    "image_transport::Republisher": ("image_transport", "republish"),
    "joy::Joy": ("joy", "joy_node"),
    "nav2_lifecycle_manager::LifecycleManager": ("nav2_lifecycle_manager", "lifecycle_manager"),
    "nav2_map_server::MapSaver": ("nav2_map_server", "map_saver_server"),
    "nav2_map_server::MapServer": ("nav2_map_server", "map_server"),
    "robot_state_publisher::RobotStatePublisher": (
        "robot_state_publisher",
        "robot_state_publisher",
    ),
    "teleop_twist_joy::TeleopTwistJoy": ("teleop_twist_joy", "teleop_node"),
    "topic_tools::DelayNode": ("topic_tools", "delay"),
    "topic_tools::DropNode": ("topic_tools", "drop"),
    "topic_tools::MuxNode": ("topic_tools", "mux"),
    "topic_tools::RelayNode": ("topic_tools", "relay"),
    "topic_tools::ThrottleNode": ("topic_tools", "throttle"),
}
