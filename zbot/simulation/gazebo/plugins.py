"""Reader of the `<plugin>` tags of Gazebo that belong to a model, of both generations."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.simulation.gazebo.drives import kind_of_drive, read_drive
from zbot.simulation.gazebo.tags import file_of, flag, is_classic, number, word, words
from zbot.simulation.robots.equipment import (
    MODEL_FRAME,
    Control,
    Drive,
    JointCommand,
    JointStates,
    LinkPoses,
    Sensor,
    TruePose,
)

if TYPE_CHECKING:
    from collections.abc import Iterable
    from xml.etree.ElementTree import Element

    from zbot.simulation.gazebo.names import Names

#: Plugins that only say what the simulator does in any case.
_SILENT = (
    *("sensors-system", "imu-system", "contact-system", "::Sensors", "::Imu", "::Contact"),
    *("physics-system", "::Physics", "scene-broadcaster", "SceneBroadcaster", "user-commands"),
    *("UserCommands", "gazebo_ros_init", "gazebo_ros_factory", "gazebo_ros_force_system"),
    "gazebo_ros_state",
)
_JOINT_STATES = ("joint_state_publisher", "joint-state-publisher", "JointStatePublisher")
_TRUE_POSES = ("p3d", "odometry-publisher", "OdometryPublisher")
_LINK_POSES = ("pose-publisher", "PosePublisher")
_CONTROL = ("ros2_control",)
_COMMANDS = {
    "JointPositionController": "position",
    "joint-position-controller": "position",
    "JointController": "velocity",
    "joint-controller": "velocity",
    "ApplyJointForce": "effort",
    "apply-joint-force": "effort",
}
#: No robot in the simulator has more joints that move.
_MOST_JOINTS = 100
_MOST_RATE_HZ, _USUAL_RATE_HZ = 200.0, 50.0


@dataclass
class Plugins:
    """What the plugins of a model do."""

    drive: Drive | None = None
    poses: list[Sensor] = field(default_factory=list)
    joint_states: list[JointStates] = field(default_factory=list)
    joint_commands: list[JointCommand] = field(default_factory=list)
    link_poses: list[LinkPoses] = field(default_factory=list)
    control: Control | None = None
    notices: list[str] = field(default_factory=list)


def read_plugins(plugins: Iterable[Element], names: Names, root: str) -> Plugins:
    """Return what plugins do.

    Args:
        plugins: The elements.
        names: The names of their topics and frames.
        root: The root link of the model.

    Raises:
        DescriptionError: A value is not valid.
    """
    found = Plugins()
    for plugin in plugins:
        file = file_of(plugin)
        if any(name in file for name in _SILENT):
            continue
        if kind_of_drive(plugin) is not None:
            found.drive = read_drive(plugin, names, root)
        elif any(name in file for name in _JOINT_STATES):
            found.joint_states.append(_joint_states(plugin, names))
        elif any(name in file for name in _TRUE_POSES):
            found.poses.append(_true_pose(plugin, names, root))
        elif any(name in file for name in _LINK_POSES):
            _add_link_poses(found, plugin, names)
        elif any(name in file for name in _CONTROL):
            found.control = _control(plugin)
        elif (kind := next((name for name in _COMMANDS if name in file), "")) and names.model:
            found.joint_commands += _joint_commands(plugin, names, _COMMANDS[kind])
        else:
            found.notices.append(f"the plugin '{_label(plugin)}'")
    return found


def _label(plugin: Element) -> str:
    name, file = plugin.get("name", ""), plugin.get("filename", "")
    return (name if "::" in name else file or name)[:60]


def _joint_states(plugin: Element, names: Names) -> JointStates:
    usual = f"/world/{getattr(names, 'world', '')}/model/{names.model}/joint_state"
    topic = names.topic(plugin, "joint_states", usual, "topic")
    rate_hz = number(plugin, 50.0, "update_rate")
    joints = words(plugin, "joint_name")
    return JointStates(topic, joints, min(max(rate_hz, 1.0), _MOST_RATE_HZ))


def _true_pose(plugin: Element, names: Names, root: str) -> TruePose:
    model = names.model
    rate_hz = number(plugin, 50.0, "update_rate", "odom_publish_frequency")
    rate_hz = min(max(rate_hz, 1.0), _MOST_RATE_HZ)
    if is_classic(plugin):
        link = word(plugin, root, "body_name", "bodyName")
        topic = names.topic(plugin, "odom", "", "topic_name", "topicName")
        frame = word(plugin, "world", "frame_name", "frameName")
        noise = number(plugin, 0.0, "gaussian_noise")
        return TruePose(link, topic, rate_hz, noise, frame, child_frame=link)
    topic = names.topic(plugin, "", f"/model/{model}/odometry", "odom_topic")
    frame = word(plugin, f"{model}/odom", "odom_frame")
    child = word(plugin, f"{model}/base_footprint", "robot_base_frame")
    tf = names.topic(plugin, "", f"/model/{model}/pose", "tf_topic")
    return TruePose(MODEL_FRAME, topic, rate_hz, 0.0, frame, child, tf)


def _add_link_poses(found: Plugins, plugin: Element, names: Names) -> None:
    """Add the poses that a plugin publishes. ROS can only use them as one message."""
    if not flag(plugin, False, "use_pose_vector_msg"):
        found.notices.append(f"the plugin '{_label(plugin)}' without <use_pose_vector_msg>")
        return
    topic = names.topic(plugin, "", f"/model/{names.model}/pose", "topic")
    rate_hz = _rate(number(plugin, 0.0, "update_frequency"))
    is_split = flag(plugin, False, "static_publisher")
    has_model = flag(plugin, False, "publish_model_pose", "publish_nested_model_pose")
    found.link_poses.append(
        LinkPoses(
            topic,
            rate_hz,
            names.model,
            has_links=flag(plugin, True, "publish_link_pose"),
            world=getattr(names, "world", "") if has_model else "",
            fixed_topic=f"{topic}_static" if is_split else "",
            fixed_rate_hz=_rate(number(plugin, rate_hz, "static_update_frequency")),
        )
    )


def _rate(given_hz: float) -> float:
    """Return a rate that the simulator can have. Gazebo's usual one is that of its steps."""
    return min(max(given_hz, 1.0), _MOST_RATE_HZ) if given_hz > 0 else _USUAL_RATE_HZ


def _control(plugin: Element) -> Control:
    files = words(plugin, "parameters")
    ros = plugin.find("ros")
    rules = (text.partition(":=") for text in words(plugin, "remapping", "argument"))
    remaps = tuple((before.strip(), after.strip()) for before, _, after in rules if after)
    name = word(plugin, "controller_manager", "controller_manager_name")
    name = word(plugin, name, "controller_manager_node_name")
    return Control(files, word(ros, "", "namespace"), remaps, name)


def _joint_commands(plugin: Element, names: Names, kind: str) -> list[JointCommand]:
    """Return the commands of a plugin: one for each joint that it names."""
    ends = {"position": "0/cmd_pos", "velocity": "cmd_vel", "effort": "cmd_force"}
    start = number(plugin, 0.0, "initial_position", "initial_velocity")
    found = []
    for joint in words(plugin, "joint_name")[:_MOST_JOINTS]:
        usual = f"/model/{names.model}/joint/{joint}/{ends[kind]}"
        topic = names.topic(plugin, "", usual, "topic", "sub_topic")
        found.append(JointCommand(joint, topic, kind, start))  # type: ignore[arg-type]
    return found
