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
    *("rqt_msg", "rqt_plot", "rqt_publisher", "rqt_reconfigure", "rqt_robot_monitor"),
    *("rqt_robot_steering", "rqt_runtime_monitor", "rqt_service_caller", "rqt_tf_tree"),
    *("rqt_top", "rqt_topic"),
)
#: Programs on the PATH of a ROS 2 installation that bundled nodes replace: name -> package.
BUNDLED_PROGRAMS: Final[dict[str, str]] = {
    "rqt": "rqt_gui",
    **{name: name for name in (*_RQT, "rviz2", "xacro")},
    **dict.fromkeys(("gz", "ign"), "gz_sim"),
    **dict.fromkeys(("gazebo", "gzserver", "gzclient"), "gazebo"),
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
    "gazebo": dict.fromkeys(("gazebo", "gzclient", "gzserver"), "simulation.gz"),
    "gazebo_plugins": {},
    "gazebo_ros": {
        "spawn_entity": "simulation.spawn_entity",
        "spawn_entity.py": "simulation.spawn_entity",
    },
    "gazebo_ros2_control": {},
    "gz_ros2_control": {},
    "gz_sim": {"gz": "simulation.gz", "ign": "simulation.gz"},
    "ign_ros2_control": {},
    "ros_gz": {},
    "ros_gz_bridge": {
        "bridge_node": "simulation.parameter_bridge",
        "parameter_bridge": "simulation.parameter_bridge",
    },
    "ros_gz_image": {"image_bridge": "simulation.image_bridge"},
    "ros_gz_sim": {"create": "simulation.create"},
    "ros_ign": {},
    "ros_ign_bridge": {"parameter_bridge": "simulation.parameter_bridge"},
    "ros_ign_gazebo": {"create": "simulation.create"},
    "ros_ign_image": {"image_bridge": "simulation.image_bridge"},
    "image_proc": {"rectify_node": "cameras.rectify"},
    "image_tools": {"cam2image": "cameras.cam2image", "showimage": "cameras.showimage"},
    "image_transport": {"republish": "images.republish"},
    "joint_state_publisher": {"joint_state_publisher": "description.joint_state_publisher"},
    "joint_state_publisher_gui": {
        "joint_state_publisher_gui": "description.joint_state_publisher_gui"
    },
    "nav2_amcl": {"amcl": "navigation.amcl"},
    "nav2_behaviors": {"behavior_server": "navigation.behavior_server"},
    "nav2_bringup": {},  # only launch files
    "nav2_bt_navigator": {"bt_navigator": "navigation.bt_navigator"},
    "nav2_collision_monitor": {"collision_monitor": "navigation.collision_monitor"},
    "nav2_controller": {"controller_server": "navigation.controller_server"},
    "nav2_lifecycle_manager": {"lifecycle_manager": "navigation.lifecycle_manager"},
    "nav2_map_server": {
        "map_saver_cli": "navigation.map_saver_cli",
        "map_saver_server": "navigation.map_saver_server",
        "map_server": "navigation.map_server",
    },
    "nav2_recoveries": {"recoveries_server": "navigation.behavior_server"},  # in ROS 2 Galactic
    "nav2_planner": {"planner_server": "navigation.planner_server"},
    "nav2_smoother": {"smoother_server": "navigation.smoother_server"},
    "nav2_velocity_smoother": {"velocity_smoother": "navigation.velocity_smoother"},
    "nav2_waypoint_follower": {"waypoint_follower": "navigation.waypoint_follower"},
    "robot_state_publisher": {"robot_state_publisher": "description.robot_state_publisher"},
    "slam_toolbox": {
        "async_slam_toolbox_node": "navigation.slam_toolbox_node",
        "sync_slam_toolbox_node": "navigation.slam_toolbox_node",
    },
    "teleop_twist_joy": {"teleop_node": "driving.teleop_twist_joy"},
    "teleop_twist_keyboard": {"teleop_twist_keyboard": "driving.teleop_twist_keyboard"},
    **{name: {name: "page.rqt"} for name in _RQT},
    "ros2_controllers_test_nodes": {
        "publisher_forward_position_controller": "control.forward_position_publisher",
        "publisher_joint_trajectory_controller": "control.joint_trajectory_publisher",
    },
    "rqt_gui": {"rqt_gui": "page.rqt", "rqt": "page.rqt"},
    "rviz2": {"rviz2": "page.rviz2"},
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
    "usb_cam": {"usb_cam_node_exe": "cameras.usb_cam"},
    "urdf_launch": {},  # only launch files
    "urdf_tutorial": {},  # as above
    "v4l2_camera": {"v4l2_camera_node": "cameras.v4l2_camera"},
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
    "image_proc::RectifyNode": ("image_proc", "rectify_node"),
    "image_tools::Cam2Image": ("image_tools", "cam2image"),
    "image_tools::ShowImage": ("image_tools", "showimage"),
    "image_transport::Republisher": ("image_transport", "republish"),
    "joy::Joy": ("joy", "joy_node"),
    "behavior_server::BehaviorServer": ("nav2_behaviors", "behavior_server"),
    "nav2_amcl::AmclNode": ("nav2_amcl", "amcl"),
    "nav2_bt_navigator::BtNavigator": ("nav2_bt_navigator", "bt_navigator"),
    "nav2_collision_monitor::CollisionMonitor": ("nav2_collision_monitor", "collision_monitor"),
    "nav2_controller::ControllerServer": ("nav2_controller", "controller_server"),
    "nav2_planner::PlannerServer": ("nav2_planner", "planner_server"),
    "nav2_smoother::SmootherServer": ("nav2_smoother", "smoother_server"),
    "nav2_velocity_smoother::VelocitySmoother": ("nav2_velocity_smoother", "velocity_smoother"),
    "nav2_waypoint_follower::WaypointFollower": ("nav2_waypoint_follower", "waypoint_follower"),
    "slam_toolbox::AsynchronousSlamToolbox": ("slam_toolbox", "async_slam_toolbox_node"),
    "slam_toolbox::SynchronousSlamToolbox": ("slam_toolbox", "sync_slam_toolbox_node"),
    "nav2_lifecycle_manager::LifecycleManager": ("nav2_lifecycle_manager", "lifecycle_manager"),
    "nav2_map_server::MapSaver": ("nav2_map_server", "map_saver_server"),
    "nav2_map_server::MapServer": ("nav2_map_server", "map_server"),
    "robot_state_publisher::RobotStatePublisher": (
        "robot_state_publisher",
        "robot_state_publisher",
    ),
    "teleop_twist_joy::TeleopTwistJoy": ("teleop_twist_joy", "teleop_node"),
    "usb_cam::UsbCamNode": ("usb_cam", "usb_cam_node_exe"),
    "v4l2_camera::V4L2Camera": ("v4l2_camera", "v4l2_camera_node"),
    "topic_tools::DelayNode": ("topic_tools", "delay"),
    "topic_tools::DropNode": ("topic_tools", "drop"),
    "topic_tools::MuxNode": ("topic_tools", "mux"),
    "topic_tools::RelayNode": ("topic_tools", "relay"),
    "topic_tools::ThrottleNode": ("topic_tools", "throttle"),
}
