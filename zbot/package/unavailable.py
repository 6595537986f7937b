"""Table of well-known ROS 2 packages that do not run in zbot, with a replacement for each."""

from __future__ import annotations

from typing import Final, NamedTuple


class Unavailable(NamedTuple):
    """Kind of a program that does not run in zbot."""

    what: str  #: what it is, e.g. `a 3D viewer in C++`
    instead: str  #: what does the same in zbot, as a sentence without a full stop


_VIEWER = Unavailable(
    "a 3D viewer in C++",
    "`zbot web` shows topics, images, plots and the graph, and `zbot foxglove` serves 3D viewers",
)
_RQT = Unavailable("a window of Qt", "`zbot web` shows the same in a browser")
_SIMULATOR = Unavailable(
    "a simulator in C++",
    "`zbot launch robot` simulates a robot in a room, and controller_manager has a mock hardware",
)
_NAVIGATION = Unavailable(
    "a navigation program in C++", "`zbot run robot_navigation` drives the simulated robot to goals"
)
_LOCALIZATION = Unavailable(
    "a filter for poses in C++",
    "diff_drive_controller and `zbot run robot_base` publish the frame from odom to base_link",
)
_ARM = Unavailable(
    "a motion planner in C++",
    "joint_trajectory_controller follows the trajectories that a program of yours sends",
)
_LIDAR = Unavailable(
    "a compiled driver of a laser scanner", "`zbot run robot_laser` publishes simulated scans"
)
_CAMERA = Unavailable(
    "a compiled driver of a camera", "`zbot run robot_camera` publishes simulated images"
)
_IMU = Unavailable(
    "a compiled driver or filter of an IMU", "`zbot run robot_imu` publishes simulated values"
)
_GPS = Unavailable(
    "a compiled driver of a GPS receiver", "a program of yours can publish the fixes"
)
_BASE = Unavailable(
    "a compiled driver of a robot",
    "`zbot run robot_base` and controller_manager's mock hardware simulate one",
)
_IMAGES = Unavailable(
    "an image program in C++", "a node in Python can do the same with cv_bridge and OpenCV"
)
_CLOUDS = Unavailable(
    "a program for scans or point clouds in C++",
    "a node in Python can do the same with sensor_msgs_py",
)
_ROSBRIDGE = Unavailable("a server for web programs", "`zbot web --rosbridge` does the same")
_FOXGLOVE = Unavailable("a server for Foxglove in C++", "`zbot foxglove` does the same")
_BRIDGE = Unavailable(
    "a bridge in C++", "`zbot web` shows images, and docs/robot.md says how zbot reaches ROS 2"
)
_MICRO = Unavailable(
    "a bridge to microcontrollers in C++",
    "a microcontroller can use Zenoh itself, see docs/wire.md",
)

#: Packages by the kind of their programs. A package in the workspace has priority over an entry.
_PACKAGES: Final = (
    (
        _VIEWER,
        """
        rviz rviz2 mapviz rviz_common rviz_default_plugins foxglove_studio plotjuggler
        """,
    ),
    (
        _RQT,
        """
        rqt_bag rqt_dep rqt_gui_cpp rqt_image_overlay rqt_joint_trajectory_controller rqt_moveit
        rqt_multiplot rqt_py_console rqt_robot_monitor rqt_robot_steering rqt_runtime_monitor
        rqt_shell rqt_srv rqt_tf_tree rqt_virtual_joy
        """,
    ),
    (
        _SIMULATOR,
        """
        gazebo gazebo_ros gazebo_plugins gazebo_ros_pkgs gazebo_ros2_control gz_ros2_control
        gz_sim ign_ros2_control ros_gz ros_gz_bridge ros_gz_image ros_gz_sim ros_ign
        ros_ign_bridge ros_ign_gazebo ros_ign_image webots_ros2_driver webots_ros2_control
        stage_ros2 flatland_server mvsim turtlebot3_fake_node turtlebot3_gazebo
        """,
    ),
    (
        _NAVIGATION,
        """
        nav2_amcl nav2_behaviors nav2_bringup nav2_bt_navigator nav2_collision_monitor
        nav2_controller nav2_costmap_2d nav2_docking nav2_planner nav2_recoveries nav2_route
        nav2_smoother nav2_velocity_smoother nav2_waypoint_follower opennav_docking
        slam_toolbox cartographer_ros slam_gmapping rtabmap_launch rtabmap_slam rtabmap_odom
        rtabmap_viz rtabmap_util explore_lite frontier_exploration
        """,
    ),
    (
        _LOCALIZATION,
        """
        robot_localization robot_pose_ekf fuse_optimizers rf2o_laser_odometry
        """,
    ),
    (
        _ARM,
        """
        moveit moveit_ros_move_group moveit_ros_visualization moveit_servo
        moveit_setup_assistant moveit_task_constructor_core moveit_ros_perception
        moveit_ros_warehouse
        """,
    ),
    (
        _LIDAR,
        """
        rplidar_ros sllidar_ros2 ydlidar_ros2_driver ydlidar urg_node urg_node2 sick_scan2
        sick_scan_xd sick_safetyscanners2 hls_lfcd_lds_driver ld08_driver ldlidar
        ldlidar_stl_ros2 ldlidar_node velodyne_driver velodyne_pointcloud velodyne_laserscan
        velodyne ouster_ros livox_ros_driver2 lslidar_driver rslidar_sdk hesai_ros_driver
        coin_d4_driver
        """,
    ),
    (
        _CAMERA,
        """
        usb_cam v4l2_camera realsense2_camera zed_wrapper depthai_ros_driver depthai_examples
        astra_camera orbbec_camera openni2_camera kinect_ros2 azure_kinect_ros_driver camera_ros
        gscam spinnaker_camera_driver pylon_ros2_camera_wrapper raspicam2_node libcamera_ros
        """,
    ),
    (
        _IMU,
        """
        imu_filter_madgwick imu_complementary_filter imu_tools phidgets_spatial bno055
        microstrain_inertial_driver xsens_mti_driver xsens_mti_ros2_driver wit_ros2_imu
        """,
    ),
    (
        _GPS,
        """
        ublox_gps nmea_navsat_driver septentrio_gnss_driver gpsd_client
        """,
    ),
    (
        _BASE,
        """
        turtlebot3_node create_driver create_bringup kobuki_node rosaria roboteq_ros2_driver
        ur_robot_driver ur_client_library franka_ros2 franka_bringup kuka_driver
        dynamixel_workbench dynamixel_hardware irobot_create_nodes phidgets_motors jackal_base
        husky_base clearpath_hardware
        """,
    ),
    (
        _IMAGES,
        """
        image_proc stereo_image_proc depth_image_proc image_view image_rotate image_tools
        image_publisher apriltag_ros apriltag_detector aruco_ros aruco_opencv
        camera_calibration_parsers darknet_ros opencv_apps
        """,
    ),
    (
        _CLOUDS,
        """
        laser_filters pointcloud_to_laserscan depthimage_to_laserscan laser_scan_matcher
        ira_laser_tools pcl_ros octomap_server spatio_temporal_voxel_layer laser_assembler
        """,
    ),
    (_ROSBRIDGE, "rosbridge_server rosapi"),
    (_FOXGLOVE, "foxglove_bridge"),
    (
        _BRIDGE,
        """
        domain_bridge mqtt_client ros1_bridge web_video_server zenoh_bridge_ros2dds
        """,
    ),
    (
        _MICRO,
        """
        micro_ros_agent rosserial_server
        """,
    ),
)
_BY_PACKAGE: Final = {name: kind for kind, names in _PACKAGES for name in names.split()}

#: Programs that launch files start by their names.
_BY_PROGRAM: Final = {
    **dict.fromkeys(("rviz2", "rviz", "mapviz", "plotjuggler"), _VIEWER),
    **dict.fromkeys(("gazebo", "gzserver", "gzclient", "gz", "ign", "webots", "stage"), _SIMULATOR),
    **dict.fromkeys(("MicroXRCEAgent", "micro_ros_agent"), _MICRO),
}
#: Programs that end when their work is done. If a launch leaves such a program out, actions that
#: wait for its end go on immediately.
_SHORT: Final = frozenset({"create", "spawn_entity.py", "spawn_entity", "remove"})


def unavailable_package(name: str) -> Unavailable | None:
    """Return what a package is if it is well known and does not run in zbot."""
    return _BY_PACKAGE.get(name)


def unavailable_program(name: str) -> Unavailable | None:
    """Return what a program on the PATH is if it is well known and does not run in zbot."""
    return _BY_PROGRAM.get(name)


def ends_by_itself(executable: str) -> bool:
    """Return whether a program ends soon in ROS 2, e.g. because it only adds a simulated robot."""
    return executable in _SHORT
