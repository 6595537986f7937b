"""Kinds of sensors that a browser can have."""

from __future__ import annotations

from dataclasses import dataclass

COMPRESSED_IMAGE = "sensor_msgs/msg/CompressedImage"
CAMERA_INFO = "sensor_msgs/msg/CameraInfo"
IMU = "sensor_msgs/msg/Imu"
NAV_SAT_FIX = "sensor_msgs/msg/NavSatFix"
FLOAT32 = "std_msgs/msg/Float32"


@dataclass(frozen=True, slots=True)
class SensorKind:
    """Sensor of a browser, and the topic on which the page publishes it."""

    key: str  #: its name in `sensors.js`
    title: str
    icon: str  #: name of a Material icon
    type_name: str
    topic: str  #: usual name, relative to the name of the browser
    frame: str  #: end of the name of its frame
    rate_hz: float  #: usual rate
    most_hz: float


CAMERA = SensorKind(
    *("camera", "Camera", "photo_camera", COMPRESSED_IMAGE),
    *("camera/image_raw/compressed", "camera_optical", 5.0, 30.0),
)
MICROPHONE = SensorKind(
    *("microphone", "Microphone level", "mic", FLOAT32, "microphone/level", "", 10.0, 50.0)
)
MOTION = SensorKind(
    *("motion", "Orientation and acceleration", "screen_rotation", IMU, "imu", "imu", 20.0, 60.0)
)
POSITION = SensorKind(
    *("position", "Position", "my_location", NAV_SAT_FIX, "fix", "gps", 1.0, 10.0)
)
KINDS = (CAMERA, MICROPHONE, MOTION, POSITION)


def camera_info_topic(topic: str) -> str:
    """Return the topic of the CameraInfo that belongs to an image's topic, as image_transport does.

    `/phone/camera/image_raw/compressed` and `/phone/camera/image_raw` give
    `/phone/camera/camera_info`.
    """
    return f"{topic.removesuffix('/compressed').rpartition('/')[0]}/camera_info"
