"""Tests of `import rclpy`: the names that programs use are zbot's."""

from __future__ import annotations

import importlib
import subprocess
import sys

import pytest

import zbot
from zbot import lifecycle
from zbot.lifecycle import LifecycleState

from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from std_srvs.srv import SetBool

#: Names that most programs import, counted in public repositories.
USED = """
rclpy: ok Parameter Future
rclpy.node: Publisher Subscription
rclpy.action: ActionClient ActionServer CancelResponse GoalResponse
rclpy.action.client: GoalStatus
rclpy.parameter: ParameterType ParameterValue
rclpy.time: Duration
rclpy.clock: ClockType
rclpy.logging: LoggingSeverity
rclpy.exceptions: InvalidHandle
rclpy.event_handler: QoSPublisherMatchedInfo QoSSubscriptionMatchedInfo
rclpy.qos_event: PublisherEventCallbacks
rclpy.lifecycle: LifecycleNode TransitionCallbackReturn State Node Publisher
rclpy.service: ServiceIntrospectionState
rclpy.qos_overriding_options: QosCallbackResult
rclpy.parameter_service: SetParameters
rclpy.signals: SignalHandlerOptions
rosidl_runtime_py: message_to_csv message_to_ordereddict message_to_yaml set_message_fields
rosidl_runtime_py.convert: message_to_ordereddict message_to_yaml get_message_slot_types
rosidl_runtime_py.set_message: set_message_fields
rosidl_runtime_py: import_message_from_namespaced_type get_interface_path
ros2topic.api: get_msg_class get_topic_names get_topic_names_and_types
ros2node.api: get_node_names get_absolute_node_name get_publisher_info get_subscriber_info
ros2node.api: get_service_server_info get_action_server_info _is_hidden_name NodeName
ros2launch.api: get_share_file_path_from_package
ros2pkg.api: get_package_names get_prefix_path
ros2service.api: get_service_names get_service_names_and_types
ros2action.api: get_action_names get_action_names_and_types
ros2param.api: call_get_parameters call_set_parameters call_list_parameters get_value
ros2param.api: call_describe_parameters get_parameter_value
ros2cli.node.direct: DirectNode add_arguments
ros2cli.node.strategy: NodeStrategy add_arguments
rosidl_runtime_py.utilities: get_message get_service get_action get_interface
rosidl_runtime_py.get_interfaces: get_interfaces get_message_interfaces get_interface_path
message_filters: Subscriber TimeSynchronizer ApproximateTimeSynchronizer Cache Chain SimpleFilter
sensor_msgs_py.point_cloud2: read_points read_points_list read_points_numpy create_cloud
sensor_msgs_py.point_cloud2: create_cloud_xyz32 dtype_from_fields PointCloud2 PointField
camera_info_manager: CameraInfoManager CameraInfoError CameraInfoMissingError genCameraName
camera_info_manager: loadCalibrationFile saveCalibration parseURL URL_file resolveURL
cv_bridge: CvBridge CvBridgeError getCvType cvtColorForDisplay
cv_bridge.boost.cv_bridge_boost: cvtColor2 cvtColorForDisplay getCvType
nav2_simple_commander.robot_navigator: BasicNavigator TaskResult RunningTask
nav2_simple_commander.footprint_collision_checker: FootprintCollisionChecker
nav2_simple_commander.line_iterator: LineIterator
nav2_simple_commander.utils: euler_to_quaternion
controller_manager: list_controllers load_controller switch_controllers unload_controller
controller_manager.controller_manager_services: service_caller ServiceNotFoundError
controller_manager.launch_utils: generate_load_controller_launch_description
controller_manager.test_utils: check_controllers_running check_if_js_published
diagnostic_updater: Updater FunctionDiagnosticTask CompositeDiagnosticTask TopicDiagnostic
diagnostic_updater: FrequencyStatusParam TimeStampStatusParam DiagnosticStatusWrapper
interactive_markers: InteractiveMarkerServer MenuHandler
interactive_markers.menu_handler: MenuHandler
laser_geometry: LaserProjection
laser_geometry.laser_geometry: LaserProjection
image_geometry: PinholeCameraModel StereoCameraModel
nav2_common.launch: RewrittenYaml ReplaceString HasNodeParams ParseMultiRobotPose
rosidl_parser.definition: NamespacedType BasicType AbstractSequence UnboundedString
rosidl_pycommon.interface_base_classes: BaseMessage BaseService BaseAction BaseImpl
tf2_ros: Buffer BufferInterface TransformListener TransformBroadcaster StaticTransformBroadcaster
tf2_ros: TransformException LookupException ConnectivityException ExtrapolationException
tf2_ros: InvalidArgumentException TimeoutException TypeException NotImplementedException
tf2_ros: TransformRegistration ConvertRegistration convert TransformStamped
tf2_ros: BufferClient BufferServer buffer transform_listener
tf2_ros.static_transform_listener: StaticTransformListener
rclpy.event_handler: QoSPublisherEventType QoSSubscriptionEventType
tf2_ros.buffer: Buffer
tf2_ros.buffer_client: BufferClient
tf2_ros.buffer_interface: BufferInterface TransformRegistration
tf2_ros.transform_listener: TransformListener
tf2_ros.transform_broadcaster: TransformBroadcaster
tf2_ros.static_transform_broadcaster: StaticTransformBroadcaster
launch_testing: post_shutdown_test parametrize actions asserts markers tools util
launch_testing.actions: ReadyToTest GTest PyTest
launch_testing.asserts: assertInStdout assertInStderr assertExitCodes assertSequentialStdout
launch_testing.asserts: EXIT_OK EXIT_SIGINT NO_CMD_ARGS
launch_testing.util: KeepAliveProc resolveProcesses NoMatchingProcessException
launch_testing.event_handlers: StdoutReadyListener
launch_testing.tools: basic_output_filter expect_output expected_output_from_file launch_process
launch_testing_ros: WaitForTopics
launch_testing_ros.tools: basic_output_filter
launch_pytest: fixture actions tools
tf2_py: BufferCore TransformException
tf2_geometry_msgs: do_transform_point do_transform_pose do_transform_vector3 PointStamped
tf2_sensor_msgs: do_transform_cloud transform_points
tf2_sensor_msgs.tf2_sensor_msgs: do_transform_cloud transform_points
tf_transformations: euler_from_quaternion quaternion_from_euler quaternion_multiply
rosbag2_py: SequentialReader SequentialWriter StorageOptions ConverterOptions TopicMetadata
rosbag2_py: StorageFilter Info BagMetadata MetadataIo Reindexer get_registered_readers
rosbag2_py: Player PlayOptions Recorder RecordOptions ServiceRequestsSource bag_rewrite
rclpy.experimental: EventsExecutor
rclpy.experimental.events_executor: EventsExecutor
rclpy.logging: _root_logger
rclpy.type_support: MsgT
rclpy.impl.implementation_singleton: rclpy_implementation
rclpy._rclpy_pybind11: RCLError InvalidHandle rmw_qos_profile_t
"""


@pytest.mark.parametrize("line", USED.split("\n")[1:-1])
def test_the_names_that_programs_use_exist(line: str) -> None:
    module_name, _, names = line.partition(": ")
    module = importlib.import_module(module_name)
    assert [name for name in names.split() if not hasattr(module, name)] == []


def test_rclpys_node_is_zbots_node() -> None:
    assert importlib.import_module("rclpy.node").Node is zbot.Node


def test_submodules_need_no_import_of_their_own() -> None:
    source = "import zbot.compat, rclpy; print(rclpy.node.Node, rclpy.qos.QoSProfile)"
    subprocess.run([sys.executable, "-c", source], check=True, timeout=100)


def test_a_missing_name_raises_pythons_error() -> None:
    with pytest.raises(AttributeError, match="has no attribute 'spinn'"):
        importlib.import_module("rclpy").spinn  # noqa: B018


def test_a_function_keeps_its_name_when_the_submodule_of_that_name_is_imported() -> None:
    importlib.import_module("rosidl_runtime_py.get_interfaces")
    function = importlib.import_module("rosidl_runtime_py").get_interfaces
    assert "std_msgs" in function()


def test_every_interface_has_the_common_bases() -> None:
    bases = importlib.import_module("rosidl_pycommon.interface_base_classes")
    assert issubclass(String, bases.BaseMessage)
    assert issubclass(SetBool, bases.BaseService)
    assert issubclass(Fibonacci, bases.BaseAction)
    assert issubclass(Fibonacci.Impl, bases.BaseImpl)
    assert bases.BaseService[SetBool.Request, SetBool.Response].__origin__ is bases.BaseService


@pytest.mark.parametrize("name", ["client.ActionClient", "server.ServerGoalHandle"])
def test_annotations_name_an_actions_impl_or_leave_it_out(name: str) -> None:
    module, _, short = name.partition(".")
    generic = getattr(importlib.import_module(f"rclpy.action.{module}"), short)
    messages = (Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback)
    assert generic.__class_getitem__((*messages, Fibonacci.Impl)) == generic[messages]


INACTIVE = LifecycleState("inactive", 2)
ACTIVE = LifecycleState("active", 3)


def test_rclpys_short_names_are_importable() -> None:
    assert lifecycle.Node is lifecycle.LifecycleNode
    assert lifecycle.NodeMixin is lifecycle.LifecycleNodeMixin
    assert lifecycle.State is lifecycle.LifecycleState
    assert lifecycle.Publisher is lifecycle.LifecyclePublisher
    assert tuple(ACTIVE) == ("active", 3)
    assert (INACTIVE.label, INACTIVE.state_id) == ("inactive", 2)
