"""Equipment of a robot: its drive and its sensors, as its description names them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from zbot.tf2.rigid import Rigid


#: Frame of the model itself, whose pose Gazebo tells. It may not be that of its root link.
MODEL_FRAME = "__model__"


@dataclass(frozen=True)
class Drive:
    """Wheels that a robot drives with.

    Attributes:
        kind: `wheels` steers by the difference between the left and the right wheels. `omni` moves
            in all directions.
        left: The joints of the left wheels. For `omni`, these are all wheels.
        right: The joints of the right wheels.
        separation: The distance between the left and the right wheels, in metres.
        radius: The radius of the wheels, in metres.
        acceleration: The largest acceleration of the robot, in m/s^2.
        speed: The largest speed of the robot, in m/s.
        signs: 1 for a wheel whose joint turns forwards, and -1 for a wheel whose joint turns
            backwards when the robot drives forwards.
        base_frame: The link whose pose the odometry tells. Empty means the root.
        tells_truth: Whether the odometry is the true pose in the world.
        odometry_tf: The topic of the transform of the odometry. Empty means none.
        wheel_tf: The topic of the transforms of the wheels. Empty means none.
        steering: The joints that steer, the left one first.
        wheel_base: The distance between the front and the rear wheels, in metres.
        steers_by_angle: Whether the turn of a command is the angle of the steering.
    """

    kind: Literal["wheels", "omni", "ackermann"]
    left: tuple[str, ...]
    right: tuple[str, ...]
    separation: float
    radius: float
    acceleration: float = 3.0
    speed: float = math.inf
    command_topic: str = "cmd_vel"
    odometry_topic: str = "odom"
    odometry_frame: str = "odom"
    base_frame: str = ""
    rate_hz: float = 50.0
    signs: tuple[float, ...] = ()
    tells_truth: bool = False
    odometry_tf: str = "/tf"
    wheel_tf: str = ""
    steering: tuple[str, ...] = ()
    wheel_base: float = math.nan
    most_steering: float = 0.6
    steers_by_angle: bool = False


#: Where a world is, if nothing says it, in degrees and metres: the middle of Berlin.
EARTH = (52.52, 13.405, 34.0)


@dataclass(frozen=True)
class Sensor:
    """What all sensors have."""

    link: str
    topic: str
    rate_hz: float
    noise: float = 0.0  #: standard deviation of a measurement
    frame: str = ""  #: frame of the messages; empty means the link


@dataclass(frozen=True)
class Lidar(Sensor):
    """Distances in many directions. Angles are in radians, distances in metres."""

    rays: int = 360
    first_angle: float = 0.0
    last_angle: float = 2 * math.pi * 359 / 360
    nearest: float = 0.12
    farthest: float = 12.0


@dataclass(frozen=True)
class Imu(Sensor):
    """Rotation and acceleration. The noise is that of the acceleration, in m/s^2."""

    turn_noise: float = 0.0  #: rad/s


@dataclass(frozen=True)
class Bumper(Sensor):
    """Contacts of the link with things and robots."""

    is_classic: bool = False  #: whether the messages are those of Gazebo Classic


@dataclass(frozen=True)
class Camera(Sensor):
    """Colour and depth images. The topic is the start of the names of its topics.

    Attributes:
        color_topic: The topic of the colour images, if it does not follow from `topic`.
        depth_topic: The topic of the depth images, likewise.
        info_topics: The topics of `CameraInfo`, likewise.
        points_topic: The topic of the points that the camera sees, if any.
        has_optical_points: Whether the z axis of the points is ahead, not the x axis.
    """

    width: int = 160
    height: int = 120
    field_of_view: float = 1.0472  #: from the left edge to the right edge, in radians
    nearest: float = 0.05
    farthest: float = 12.0
    has_color: bool = True
    has_depth: bool = True
    color_topic: str = ""
    depth_topic: str = ""
    info_topics: tuple[str, ...] = ()
    points_topic: str = ""
    has_optical_points: bool = False


@dataclass(frozen=True)
class TruePose(Sensor):
    """True pose of a link in the world, as an odometry."""

    child_frame: str = ""
    tf_topic: str = ""  #: topic of the same pose as a transform; empty means none


@dataclass(frozen=True)
class JointStates:
    """Positions and velocities of joints, as Gazebo's plugins publish them."""

    topic: str
    joints: tuple[str, ...] = ()  #: empty means all
    rate_hz: float = 50.0


@dataclass(frozen=True)
class LinkPoses:
    """Poses of links in the frame of their model, as Gazebo's pose publisher sends them.

    Attributes:
        world: The frame of the world. Empty means that the pose of the model is not sent.
        fixed_topic: The topic of links that no joint moves. Empty means the same topic.
        fixed_rate_hz: The rate of these links.
    """

    topic: str
    rate_hz: float
    model: str  #: frame of the model
    has_links: bool = True
    world: str = ""
    fixed_topic: str = ""
    fixed_rate_hz: float = 1.0


@dataclass(frozen=True)
class JointCommand:
    """Topic that moves one joint.

    Attributes:
        kind: What its numbers are: positions, velocities, or forces and torques.
        start: The first command.
    """

    joint: str
    topic: str
    kind: Literal["position", "velocity", "effort"]
    start: float = 0.0


@dataclass(frozen=True)
class Control:
    """Controller manager that a robot's description starts in the simulator.

    Attributes:
        files: Parameter files of the controllers.
        namespace: The namespace of the manager.
        remaps: Pairs of a name and its replacement.
        node_name: The name of the manager's node.
    """

    files: tuple[str, ...] = ()
    namespace: str = ""
    remaps: tuple[tuple[str, str], ...] = ()
    node_name: str = "controller_manager"


@dataclass(frozen=True)
class CloudLidar(Lidar):
    """Lidar with several rows of rays. It measures points."""

    rows: int = 16
    lowest_angle: float = -0.2618
    highest_angle: float = 0.2618


@dataclass(frozen=True)
class Sonar(Sensor):
    """Distance to the nearest thing in a cone along the x axis of the link."""

    field_of_view: float = 0.5  #: from one side of the cone to the other, in radians
    nearest: float = 0.02
    farthest: float = 4.0


@dataclass(frozen=True)
class Gps(Sensor):
    """Place on the Earth. The noise is that of the horizontal place, in metres."""

    height_noise: float = 0.0  #: metres
    #: Latitude and longitude in degrees, and altitude in metres, of the origin of the world. None
    #: means that the world says where it is.
    origin: tuple[float, float, float] | None = None


@dataclass(frozen=True)
class Battery(Sensor):
    """Charge of a battery. The noise is that of the voltage."""

    voltage: float = 12.0  #: of the full battery, in volts
    capacity: float = 2.0  #: ampere hours
    idle_current: float = 0.5  #: amperes, while the robot stands
    motion_current: float = 3.0  #: more amperes at 1 m/s
    turn_share: float = 0.1  #: metres that cost as much as a turn of 1 rad


@dataclass(frozen=True)
class Equipment:
    """Drive and sensors of a robot, and the friction of its links."""

    drive: Drive | None = None
    sensors: tuple[Sensor, ...] = ()
    friction: dict[str, float] = field(default_factory=dict)  #: by link
    notices: tuple[str, ...] = ()  #: what the description names, but the simulator does not have
    #: Frames of sensors that are not in the origin of a link: the link, and the pose in it.
    mounts: dict[str, tuple[str, Rigid]] = field(default_factory=dict)
    joint_states: tuple[JointStates, ...] = ()
    joint_commands: tuple[JointCommand, ...] = ()
    link_poses: tuple[LinkPoses, ...] = ()
    control: Control | None = None
