"""Table of well-known ROS 2 packages that do not run in zbot, with a replacement for each."""

from __future__ import annotations

from importlib.util import find_spec
from typing import TYPE_CHECKING, Final, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Collection


class Unavailable(NamedTuple):
    """Kind of a program that does not run in zbot."""

    what: str  #: what it is, e.g. `a 3D viewer in C++`
    instead: str  #: what does the same in zbot, as a sentence without a full stop
    why: str = "does not run here"


_VIEWER = Unavailable(
    "a 3D viewer in C++",
    "`zbot web` shows topics, images, plots and the graph, and `zbot foxglove` serves 3D viewers",
)
_RVIZ2 = Unavailable(
    "a 3D viewer in C++", 'after `pip install "zbot[view]"`, zbot shows its displays in a browser'
)
_RQT = Unavailable("a window of Qt", "`zbot web` shows the same in a browser")
_RQT_CONTROLLERS = Unavailable(
    "a window of Qt", "the spawner and the unspawner of controller_manager switch controllers"
)
_SIMULATOR = Unavailable(
    "a simulator in C++",
    "`zbot launch robot` simulates a robot in a room, and controller_manager has a mock hardware",
)
_GAZEBO = Unavailable(
    "a simulator in C++", 'after `pip install "zbot[sim]"`, zbot\'s simulator answers in its place'
)
_NAVIGATION = Unavailable(
    "a navigation program in C++",
    "`zbot launch nav2_bringup bringup_launch.py` maps, localises and drives a robot to goals",
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
#: Kind of the containers of components.
COMPONENTS: Final = Unavailable(
    "a program that loads C++ libraries",
    "start each node that is in Python as Node(package=..., executable=...)",
)
_ROBOT = Unavailable(
    "a package of a robot",
    "put its sources into the folder src of your workspace, and its Python parts run",
    "is not here",
)
_DEMO = Unavailable("a demo in C++", "demo_nodes_py and `zbot run talker` show the same in Python")
_CONTROL = Unavailable(
    "a part of ros2_control in C++",
    "controller_manager has a mock hardware, and docs/robot-nodes.md lists the controllers",
)
_MOTORS = Unavailable(
    "a compiled driver of motors or a bus", "a program of yours can use the device in Python"
)
_MOVEIT = Unavailable(
    "a package of MoveIt in Python",
    "put these four repositories of GitHub into the folder src of your workspace: moveit/moveit2, "
    "PickNikRobotics/launch_param_builder, and the branches ros2 of moveit/srdfdom and "
    "ros/urdf_parser_py, and type: pip install lxml",
    "is not here",
)
_KEYS = Unavailable(
    "a program that reads keys",
    "`zbot run teleop_twist_keyboard teleop_twist_keyboard` does the same",
    "is not here",
)
_GRAPHICS = Unavailable(
    "a program for NVIDIA's graphics processors",
    "a node in Python can do the same with cv_bridge and OpenCV",
)
_AUTOWARE = Unavailable(
    "a part of Autoware in C++", "nav2_bringup maps, localises and drives a robot to goals"
)
_OTHER = Unavailable(
    "a package of ROS 2",
    "put its sources into the folder src of your workspace, and its Python parts run",
    "is not here",
)

#: Packages by the kind of their programs. A package in the workspace has priority over an entry.
_PACKAGES: Final = (
    (
        _VIEWER,
        """
        rviz mapviz rviz_common rviz_default_plugins foxglove_studio plotjuggler
        plotjuggler_ros rviz_imu_plugin rviz_satellite rviz_visual_tools rviz_2d_overlay_plugins
        nav2_rviz_plugins turtlebot4_viz clearpath_viz leo_viz
        """,
    ),
    (
        _RQT,
        """
        rqt_bag rqt_dep rqt_gui_cpp rqt_image_overlay rqt_joint_trajectory_controller rqt_moveit
        rqt_multiplot rqt_py_console rqt_shell rqt_srv rqt_virtual_joy rqt_gauges
        rqt_play_motion_builder
        """,
    ),
    (_RQT_CONTROLLERS, "rqt_controller_manager"),
    (
        _SIMULATOR,
        """
        gazebo_ros_pkgs webots_ros2_driver webots_ros2_control stage_ros2
        flatland_server mvsim turtlebot3_fake_node turtlebot3_gazebo gazebo_dev
        gazebo_model_attachment_plugin gz_ros2_control_demos gz_ros2_control_tests
        ign_ros2_control_demos ros_gz_sim_demos ros_ign_gazebo_demos webots_ros2 webots_ros2_core
        webots_ros2_crazyflie webots_ros2_epuck webots_ros2_husarion webots_ros2_importer
        webots_ros2_mavic webots_ros2_tesla webots_ros2_tiago webots_ros2_turtlebot
        webots_ros2_universal_robot webots_ros2_tests turtlebot3_simulations
        turtlebot3_manipulation_gazebo turtlebot4_simulator turtlebot4_ignition_bringup
        turtlebot4_ignition_toolbox turtlebot4_ignition_gui_plugins turtlebot4_gz_bringup
        turtlebot4_gz_toolbox turtlebot4_gz_gui_plugins irobot_create_gz_bringup
        irobot_create_gz_toolbox irobot_create_gz_plugins irobot_create_gz_sim
        irobot_create_ignition_bringup irobot_create_ignition_toolbox irobot_create_ignition_plugins
        irobot_create_ignition_sim irobot_create_gazebo_bringup irobot_create_gazebo_plugins
        irobot_create_gazebo_sim nav2_minimal_tb3_sim nav2_minimal_tb4_sim clearpath_gz
        clearpath_simulator leo_gz_bringup leo_gz_plugins leo_gz_worlds leo_simulator
        husarion_gz_worlds tiago_gazebo pmb2_gazebo pal_gazebo_worlds ur_simulation_gz
        ur_simulation_ignition rmf_building_sim_gz_plugins velodyne_gazebo_plugins
        velodyne_simulator mujoco_ros2_control mujoco_vendor dolly_gazebo dolly_ignition
        """,
    ),
    (
        _NAVIGATION,
        """
        nav2_costmap_2d nav2_docking nav2_route opennav_docking cartographer_ros
        slam_gmapping rtabmap_launch rtabmap_slam rtabmap_odom rtabmap_viz rtabmap_util explore_lite
        frontier_exploration navigation2 nav2_behavior_tree nav2_core nav2_util nav2_voxel_grid
        nav2_mppi_controller nav2_regulated_pure_pursuit_controller nav2_rotation_shim_controller
        nav2_graceful_controller nav2_dwb_controller nav2_navfn_planner nav2_smac_planner
        nav2_theta_star_planner nav2_constrained_smoother nav2_system_tests opennav_docking_bt
        opennav_docking_core opennav_following opennav_coverage cartographer cartographer_rviz
        rtabmap rtabmap_ros rtabmap_demos rtabmap_examples rtabmap_sync rtabmap_conversions
        rtabmap_rviz_plugins rtabmap_costmap_plugins turtlebot3_navigation2 turtlebot3_cartographer
        turtlebot4_navigation create3_lidar_slam clearpath_nav2_demos stretch_nav2 beluga_amcl
        behaviortree_cpp mola mola_lidar_odometry kiss_icp rmf_traffic_ros2 rmf_fleet_adapter
        lidarslam multirobot_map_merge
        """,
    ),
    (
        _LOCALIZATION,
        """
        robot_localization robot_pose_ekf fuse_optimizers rf2o_laser_odometry fuse fuse_core
        fuse_models fuse_publishers fuse_variables fusioncore_ros
        """,
    ),
    (
        _ARM,
        """
        moveit moveit_ros_move_group moveit_ros_visualization moveit_servo moveit_setup_assistant
        moveit_task_constructor_core moveit_ros_perception moveit_ros_warehouse moveit_core
        moveit_common moveit_ros moveit_ros_planning moveit_ros_planning_interface
        moveit_ros_robot_interaction moveit_ros_control_interface moveit_ros_benchmarks
        moveit_ros_occupancy_map_monitor moveit_ros_trajectory_cache moveit_ros_tests
        moveit_hybrid_planning moveit_kinematics moveit_planners moveit_planners_ompl
        moveit_planners_chomp moveit_planners_stomp moveit_plugins moveit_simple_controller_manager
        moveit_py moveit_runtime moveit_visual_tools moveit2_tutorials
        moveit_task_constructor_capabilities moveit_task_constructor_demo
        moveit_task_constructor_visualization warehouse_ros warehouse_ros_mongo warehouse_ros_sqlite
        pilz_industrial_motion_planner pilz_industrial_motion_planner_testutils chomp_motion_planner
        pick_ik trac_ik trac_ik_kinematics_plugin
        """,
    ),
    (
        _LIDAR,
        """
        rplidar_ros sllidar_ros2 ydlidar_ros2_driver ydlidar urg_node urg_node2 sick_scan2
        sick_scan_xd sick_safetyscanners2 hls_lfcd_lds_driver ld08_driver ldlidar ldlidar_stl_ros2
        ldlidar_node velodyne_driver velodyne_pointcloud velodyne_laserscan velodyne ouster_ros
        livox_ros_driver2 lslidar_driver rslidar_sdk hesai_ros_driver coin_d4_driver ros2_ouster
        sick_scan urg_c laser_proc sick_safetyscanners xv_11_driver xv_11_laser_driver lms1xx
        """,
    ),
    (
        _CAMERA,
        """
        realsense2_camera zed_wrapper depthai_ros_driver depthai_examples
        astra_camera orbbec_camera openni2_camera kinect_ros2 azure_kinect_ros_driver camera_ros
        gscam spinnaker_camera_driver pylon_ros2_camera_wrapper raspicam2 raspicam2_node
        libcamera_ros depthai
        depthai_bridge depthai_filters depthai_ros zed_components camera_aravis2 gscam2
        spinnaker_synchronized_camera_driver compressed_image_transport
        compressed_depth_image_transport theora_image_transport ffmpeg_image_transport
        image_transport_plugins point_cloud_transport libcamera
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
        ublox_gps nmea_navsat_driver septentrio_gnss_driver gpsd_client ublox ublox_dgnss
        ublox_dgnss_node gps_tools gps_umd
        """,
    ),
    (
        _BASE,
        """
        turtlebot3_node create_driver kobuki_node rosaria roboteq_ros2_driver ur_robot_driver
        ur_client_library franka_ros2 kuka_driver dynamixel_workbench dynamixel_hardware
        irobot_create_nodes phidgets_motors jackal_base husky_base clearpath_hardware
        turtlebot4_base turtlebot4_node create_robot kobuki_core kobuki_velocity_smoother
        ur_controllers kortex_driver kortex_api franka_gripper franka_hardware
        franka_robot_state_broadcaster franka_example_controllers dynamixel_sdk
        dynamixel_sdk_examples dynamixel_hardware_interface mavros mavros_extras
        """,
    ),
    (
        _IMAGES,
        """
        stereo_image_proc depth_image_proc image_view image_rotate
        image_publisher apriltag_ros apriltag_detector aruco_ros aruco_opencv
        camera_calibration_parsers darknet_ros opencv_apps image_pipeline find_object_2d apriltag
        apriltag_draw apriltag_mit aruco tracetools_image_pipeline
        """,
    ),
    (
        _CLOUDS,
        """
        laser_filters pointcloud_to_laserscan depthimage_to_laserscan laser_scan_matcher
        ira_laser_tools pcl_ros octomap_server spatio_temporal_voxel_layer laser_assembler
        pcl_conversions perception_pcl octomap_mapping octomap_rviz_plugins grid_map grid_map_demos
        grid_map_visualization laser_segmentation
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
    (
        COMPONENTS,
        """
        rclcpp_components
        """,
    ),
    (
        _ROBOT,
        """
        turtlebot3_bringup turtlebot3_example turtlebot4_robot turtlebot4_bringup
        create3_republisher create3_coverage create3_teleop create3_examples_py
        irobot_create_toolbox irobot_create_control irobot_create_common_bringup ur_bringup
        kortex_bringup leo_bringup leo_robot leo_fw leo_teleop clearpath_common clearpath_control
        clearpath_sensors clearpath_robot clearpath_customization clearpath_manipulators
        clearpath_bt_joy tiago_bringup tiago_robot pmb2_bringup pmb2_robot
        tiago_controller_configuration open_manipulator_bringup open_manipulator_x_bringup
        stretch_core rosbot_bringup px4_ros_com franka_bringup create_bringup robotiq_controllers
        ur_calibration ur_description ur_moveit_config leo_description leo zed_description
        realsense2_description depthai_descriptions velodyne_description flir_camera_description
        turtlebot3_description turtlebot4_description turtlebot3_manipulation_description
        turtlebot3_manipulation_moveit_config irobot_create_description create_description
        kortex_description kinova_gen3_6dof_robotiq_2f_85_moveit_config
        kinova_gen3_7dof_robotiq_2f_85_moveit_config kinova_gen3_lite_moveit_config
        franka_description franka_fr3_moveit_config franka_moveit_config robotiq_description
        moveit_resources moveit_resources_panda_description moveit_resources_panda_moveit_config
        moveit_resources_fanuc_description moveit_resources_fanuc_moveit_config
        moveit_resources_pr2_description moveit_resources_prbt_support nav2_minimal_tb4_description
        ros2_control_demo_description clearpath_description clearpath_platform_description
        clearpath_sensors_description clearpath_mounts_description
        clearpath_manipulators_description open_manipulator_description
        open_manipulator_x_description open_manipulator_moveit_config
        open_manipulator_x_moveit_config tiago_description tiago_moveit_config pmb2_description
        pal_gripper_description husarion_components_description rosbot_description
        ros_components_description
        champ_bringup champ_description champ_gazebo sjtu_drone_bringup sjtu_drone_description
        kobuki_description turtlebot4_diagnostics turtlebot4_setup
        """,
    ),
    (
        _DEMO,
        """
        composition dummy_map_server dummy_sensors dummy_robot_bringup intra_process_demo
        pendulum_control quality_of_service_demo_cpp logging_demo topic_statistics_demo
        demo_nodes_cpp_native turtle_tf2_cpp examples_rclcpp_minimal_publisher
        examples_rclcpp_minimal_subscriber examples_rclcpp_minimal_client
        examples_rclcpp_minimal_service examples_rclcpp_minimal_timer
        examples_rclcpp_minimal_composition examples_rclcpp_minimal_action_client
        examples_rclcpp_minimal_action_server examples_rclcpp_multithreaded_executor
        examples_rclcpp_wait_set
        """,
    ),
    (
        _CONTROL,
        """
        ros2_control ros2_controllers hardware_interface joint_limits controller_interface
        transmission_interface ros2_control_test_assets ros2_control_demos ros2controlcli
        force_torque_sensor_broadcaster imu_sensor_broadcaster joint_trajectory_controller
        diff_drive_controller topic_based_ros2_control interactive_marker_twist_server
        """,
    ),
    (
        _MOTORS,
        """
        ros2_socketcan canopen canopen_ros2_control canopen_402_driver vesc vesc_driver
        vesc_ackermann odrive_can serial_driver phidgets_drivers
        """,
    ),
    (_KEYS, "key_teleop turtlebot3_teleop"),
    (_MOVEIT, "moveit_configs_utils launch_param_builder srdfdom urdf_parser_py"),
    (
        _OTHER,
        """
        camera_calibration
        nav2_loopback_sim quality_of_service_demo_py ackermann_mux mouse_teleop
        teleop_tools twist_stamper system_modes robot_upstart topic_monitor
        turtle_tf2_py rmf_demos rmf_demos_gz audio_capture audio_play audio_common sound_play
        smach_ros executive_smach clearpath_config clearpath_generator_common
        picknik_ament_copyright launch_pal launch_remote_ssh mogi_trajectory_server nav2_wfd
        robot_calibration simple_grasping
        """,
    ),
)
#: Packages of a family, by the beginning of their names.
_FAMILIES: Final = (
    ("autoware_", _AUTOWARE),
    ("interbotix_", _ROBOT),
    ("isaac_ros_", _GRAPHICS),
)
_BY_PACKAGE: Final = {name: kind for kind, names in _PACKAGES for name in names.split()}
#: Packages, also the names of their programs, that zbot replaces if a module is installed.
_WITHOUT_EXTRA: Final = {
    "rviz2": ("viser", _RVIZ2),
    **dict.fromkeys(
        [
            "gazebo",
            "gazebo_ros",
            "gazebo_plugins",
            "gazebo_ros2_control",
            "gz_ros2_control",
            "gz_sim",
            "ign_ros2_control",
            "ros_gz",
            "ros_gz_bridge",
            "ros_gz_image",
            "ros_gz_sim",
            "ros_ign",
            "ros_ign_bridge",
            "ros_ign_gazebo",
            "ros_ign_image",
            "gzserver",
            "gzclient",
            "gz",
            "ign",
        ],
        ("mujoco", _GAZEBO),
    ),
}

#: Variable in which a launch gives its nodes the full names of the nodes that it has left out.
LEFT_OUT_VARIABLE: Final = "ZBOT_LEFT_OUT"

_COMPILED = Unavailable("a C++ program", "zbot has no program in Python that does the same")
_LACKING = Unavailable(
    "a program of ROS 2 in Python",
    "put the sources of its package into your workspace",
    "is not here",
)
_LOCALIZER = Unavailable(
    "the localization of slam_toolbox in C++",
    "`zbot launch nav2_bringup localization_launch.py map:=MAP.yaml` localizes in a saved map",
)
_SERVER = Unavailable(
    "a simulator in C++",
    "`zbot launch ros_gz_sim gz_sim.launch.py gz_args:='-s WORLD'` starts zbot's simulator",
)
_WINDOW = Unavailable("a window with images", "`zbot web` shows the images of each topic")
#: Programs that zbot lacks, of the packages of which zbot has other programs.
_PROGRAMS: Final = {
    ("demo_nodes_cpp", _COMPILED): """
        add_two_ints_client_async allocator_tutorial allocator_tutorial_custom
        allocator_tutorial_pmr content_filtering_publisher content_filtering_subscriber
        even_parameters_node introspection_client introspection_service list_parameters
        list_parameters_async listener_best_effort listener_serialized_message
        matched_event_detect one_off_timer parameter_event_handler parameter_events
        parameter_events_async reuse_timer set_and_get_parameters set_and_get_parameters_async
        set_parameters_callback talker_loaned_message talker_serialized_message use_logger_service
    """,
    ("demo_nodes_py", _LACKING): """
        add_two_ints_client_async async_param_client introspection_client introspection_service
        listener_qos listener_serialized matched_event_detect set_parameters_callback talker_qos
        talker_serialized use_logger_service
    """,
    ("diagnostic_aggregator", _COMPILED): "add_analyzer",
    ("image_proc", _COMPILED): """
        crop_decimate_node crop_non_zero_node debayer_node image_proc resize_node track_marker_node
    """,
    ("image_transport", _COMPILED): "list_transports",
    ("joy", _COMPILED): "game_controller_node joy_enumerate_devices",
    ("joy_teleop", _LACKING): "incrementer_server",
    ("lifecycle", _COMPILED): "lifecycle_listener lifecycle_service_client",
    ("nav2_collision_monitor", _COMPILED): "collision_detector",
    ("nav2_map_server", _COMPILED): "costmap_filter_info_server vector_object_server",
    ("ros_gz_bridge", _COMPILED): "bridge_types static_bridge",
    ("ros_gz_sim", _COMPILED): "delete_entity remove set_entity_pose",
    ("ros_gz_sim", _SERVER): "gzserver",
    ("ros_ign_bridge", _COMPILED): "static_bridge",
    ("slam_toolbox", _COMPILED): "merge_maps_kinematic",
    ("slam_toolbox", _LOCALIZER): """
        lifelong_slam_toolbox_node localization_slam_toolbox_node
        map_and_localization_slam_toolbox_node
    """,
    ("tf2_ros", _COMPILED): "buffer_server",
    ("topic_tools", _COMPILED): "demux",
    ("topic_tools", _LACKING): "relay_field transform",
    ("twist_mux", _COMPILED): "twist_marker",
    ("twist_mux", _LACKING): "joystick_relay joystick_relay.py",
    ("usb_cam", _WINDOW): "show_image show_image.py",
}
_BY_EXECUTABLE: Final = {
    (package, name): kind for (package, kind), names in _PROGRAMS.items() for name in names.split()
}

#: Programs that launch files start by their names.
_BY_PROGRAM: Final = {
    **dict.fromkeys(("rviz", "mapviz", "plotjuggler"), _VIEWER),
    **dict.fromkeys(("webots", "stage"), _SIMULATOR),
    **dict.fromkeys(("MicroXRCEAgent", "micro_ros_agent"), _MICRO),
}
#: Programs that end when their work is done. If a launch leaves such a program out, actions that
#: wait for its end go on immediately.
_SHORT: Final = frozenset({"create", "spawn_entity.py", "spawn_entity", "remove"})


def unavailable_packages() -> Collection[str]:
    """Return the names of the well-known packages that do not run in zbot."""
    return _BY_PACKAGE.keys() | _WITHOUT_EXTRA.keys()


def unavailable_package(name: str) -> Unavailable | None:
    """Return what a package is if it is well known and does not run in zbot."""
    return _without_extra(name) or _BY_PACKAGE.get(name) or _of_family(name)


def unavailable_executable(package: str, name: str) -> Unavailable | None:
    """Return what a program is if zbot lacks it, but has other programs of its package."""
    return _BY_EXECUTABLE.get((package, name))


def unavailable_program(name: str) -> Unavailable | None:
    """Return what a program on the PATH is if it is well known and does not run in zbot."""
    return _without_extra(name) or _BY_PROGRAM.get(name)


def _of_family(name: str) -> Unavailable | None:
    """Return what a package is if its name begins as those of a family. Messages are not meant."""
    if name.endswith(("_msgs", "_interfaces")):
        return None
    return next((kind for beginning, kind in _FAMILIES if name.startswith(beginning)), None)


def _without_extra(name: str) -> Unavailable | None:
    """Return what a package or a program is if zbot replaces it, but lacks a module for that."""
    module, kind = _WITHOUT_EXTRA.get(name, ("", None))
    return None if kind is None or find_spec(module) is not None else kind


def ends_by_itself(executable: str) -> bool:
    """Return whether a program ends soon in ROS 2, e.g. because it only adds a simulated robot."""
    return executable in _SHORT
