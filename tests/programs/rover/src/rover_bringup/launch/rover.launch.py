from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, RegisterEventHandler
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import (
    Command,
    FindExecutable,
    LaunchConfiguration,
    PathJoinSubstitution,
)
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description() -> LaunchDescription:
    description = PathJoinSubstitution(
        [FindPackageShare("rover_description"), "urdf", "rover.urdf.xacro"]
    )
    config = PathJoinSubstitution([FindPackageShare("rover_bringup"), "config"])
    xacro = PathJoinSubstitution([FindExecutable(name="xacro")])
    robot_description = {
        "robot_description": ParameterValue(Command([xacro, " ", description]), value_type=str)
    }
    broadcaster = Node(
        package="controller_manager",
        executable="spawner",
        arguments=["joint_state_broadcaster", "--controller-manager", "/controller_manager"],
    )
    controllers = Node(
        package="controller_manager",
        executable="spawner",
        arguments=["base_controller", "arm_controller", "-c", "/controller_manager"],
    )
    return LaunchDescription(
        [
            DeclareLaunchArgument("rviz", default_value="true"),
            DeclareLaunchArgument("gazebo", default_value="true"),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                output="both",
                parameters=[robot_description],
            ),
            Node(
                package="controller_manager",
                executable="ros2_control_node",
                parameters=[PathJoinSubstitution([config, "controllers.yaml"])],
                output="both",
            ),
            broadcaster,
            RegisterEventHandler(OnProcessExit(target_action=broadcaster, on_exit=[controllers])),
            Node(package="joy", executable="joy_node", parameters=[{"autorepeat_rate": 20.0}]),
            Node(
                package="teleop_twist_joy",
                executable="teleop_node",
                name="teleop_twist_joy_node",
                parameters=[PathJoinSubstitution([config, "teleop.yaml"])],
                remappings=[("cmd_vel", "joy_vel")],
            ),
            Node(
                package="twist_mux",
                executable="twist_mux",
                parameters=[PathJoinSubstitution([config, "twist_mux.yaml"])],
                remappings=[("cmd_vel_out", "/base_controller/cmd_vel")],
            ),
            Node(
                package="rviz2",
                executable="rviz2",
                arguments=["-d", PathJoinSubstitution([config, "rover.rviz"])],
                condition=IfCondition(LaunchConfiguration("rviz")),
            ),
            Node(package="rplidar_ros", executable="rplidar_composition", output="screen"),
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(
                    PathJoinSubstitution(
                        [FindPackageShare("stage_ros2"), "launch", "world.launch.py"]
                    )
                ),
                launch_arguments={"gui": "false"}.items(),
                condition=IfCondition(LaunchConfiguration("gazebo")),
            ),
        ]
    )
