"""Reader of the plugins of Gazebo that drive a robot."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Literal

from zbot.simulation.gazebo.tags import file_of, flag, is_classic, number, word, words
from zbot.simulation.robots.equipment import Drive

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from zbot.simulation.gazebo.names import Names

_OMNI = ("planar_move", "VelocityControl", "velocity-control", "mecanum", "Mecanum", "omni")
_ACKERMANN = ("ackermann", "Ackermann")
_WHEELS = ("diff_drive", "diff-drive", "DiffDrive", "skid_steer", "TrackedVehicle")
_MOST_RATE_HZ = 50.0


def kind_of_drive(plugin: Element) -> Literal["wheels", "omni", "ackermann"] | None:
    """Return the kind of the drive, or None if a plugin is no drive."""
    file = file_of(plugin)
    if any(name in file for name in _ACKERMANN):
        return "ackermann"
    if any(name in file for name in _OMNI):
        return "omni"
    return "wheels" if any(name in file for name in _WHEELS) else None


def read_drive(plugin: Element, names: Names, root: str) -> Drive:
    """Return the drive of a plugin.

    Args:
        plugin: The plugin.
        names: The names of its topics and frames.
        root: The root link of the robot.

    Raises:
        DescriptionError: A number is not valid.
    """
    kind = kind_of_drive(plugin) or "wheels"
    left, right = (_joints(plugin, side) for side in ("left", "right"))
    diameter = number(plugin, math.nan, "wheel_diameter", "wheelDiameter")
    rate_hz = number(plugin, 50.0, "update_rate", "odom_publish_frequency", "publish_rate")
    classic, model = is_classic(plugin), names.model
    most = number(plugin, 0.0, "max_linear_acceleration", "max_wheel_acceleration")
    frame = word(plugin, f"{model}/odom" if model and not classic else "odom", *_ODOM_FRAMES)
    usual_base = "base_footprint" if classic else names.link_frame(root) if model else ""
    base = word(plugin, usual_base, "robot_base_frame", "child_frame_id")
    speed = number(plugin, 0.0, "max_linear_velocity", "max_velocity")
    is_set = flag(plugin, not model, "publish_odom_tf") or not classic
    odometry = names.topic(plugin, "odom", f"/model/{model}/odometry", *_ODOM_TOPICS)
    return Drive(
        kind,
        left,
        right,
        number(plugin, math.nan, "wheel_separation", "wheelSeparation"),
        number(plugin, diameter / 2, "wheel_radius"),
        most if most > 0 else 3.0,
        speed if speed > 0 else math.inf,
        names.topic(plugin, "cmd_vel", f"/model/{model}/cmd_vel", "command_topic", "topic"),
        odometry if model else _plain_odometry(odometry),
        frame if model else frame.rpartition("/")[2],
        base if model else base.rpartition("/")[2],
        min(max(rate_hz, 1.0), _MOST_RATE_HZ),
        tells_truth=classic and bool(model) and _is_true(plugin, kind),
        odometry_tf=names.tf(plugin, is_set),
        wheel_tf="/tf" if model and classic and flag(plugin, False, "publish_wheel_tf") else "",
        steering=(*_joints(plugin, "left", "steering_"), *_joints(plugin, "right", "steering_")),
        wheel_base=number(plugin, math.nan, "wheel_base"),
        most_steering=number(plugin, 0.6, "steering_limit", "max_steer"),
        steers_by_angle=classic or flag(plugin, False, "use_steering_angle"),
    )


_ODOM_FRAMES = ("odometry_frame", "frame_id")
_ODOM_TOPICS = ("odometry_topic", "odom_topic")


def _plain_odometry(topic: str) -> str:
    return "odom" if topic == "odometry" else topic


def _is_true(plugin: Element, kind: str) -> bool:
    """Return whether the odometry of a plugin of Gazebo Classic is the true pose."""
    source = word(plugin, "world", "odometry_source").lower()
    return kind != "wheels" or source in {"1", "world"}


def _joints(plugin: Element, side: str, what: str = "") -> tuple[str, ...]:
    """Return the joints of a side. `what` is `steering_` for the joints that steer."""
    tags = [f"{side}_{what}joint"]
    if not what:
        tags += [f"{start}_{side}_joint" for start in ("front", "rear", "back")]
        tags += [f"{side}_{end}_joint" for end in ("front", "rear")]
        tags += [f"{start}_{side}_joint" for start in ("front", "rear")] + [f"{side}Joint"]
    else:
        tags.append(f"front_{side}_steering_joint")
    found = words(plugin, *dict.fromkeys(tags))
    return tuple(dict.fromkeys(found))
