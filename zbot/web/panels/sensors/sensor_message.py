"""Messages of the readings that a browser sends.

A reading is a list. Its values come from any program that opens the page, so each function returns
None for a reading that is not right.
"""

from __future__ import annotations

import base64
import binascii
import math
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.interfaces import get_message
from zbot.web.panels.sensors.sensor_kind import (
    CAMERA_INFO,
    COMPRESSED_IMAGE,
    FLOAT32,
    IMU,
    NAV_SAT_FIX,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Largest picture, in bytes. The websocket of the page takes messages up to 1 MB, and the picture
#: is a third longer on its way.
MOST_PICTURE_BYTES = 700_000
_JPEG = b"\xff\xd8\xff"
_MOST_PIXELS = 10_000
_MEASURED = ("orientation", "angular_velocity", "linear_acceleration")
_NO_DATA = -1.0  # first element of a covariance: the sensor does not measure this
# A browser gives the radius in which the position is with a probability of 95 %. For a standard
# deviation, these are the quantiles of the distribution in two dimensions (Rayleigh) and in one.
_DEVIATIONS_IN_PLANE = 2.4477
_DEVIATIONS_IN_HEIGHT = 1.96
_UNKNOWN_HEIGHT_M2 = 1e6  # one kilometre: the height is not known


class Picture(NamedTuple):
    """Image of a camera and its CameraInfo, with the same header."""

    image: Any
    info: Any


def picture(reading: Sequence[Any], stamp: Any, frame_id: str) -> Picture | None:
    """Return the messages of a camera.

    Args:
        reading: The JPEG in base 64, its width and its height.
        stamp: The stamp.
        frame_id: The frame of the camera: x to the right, y down, z ahead.
    """
    try:
        text, width, height = reading
        data = base64.b64decode(text, validate=True)
        width, height = int(width), int(height)
    except (TypeError, ValueError, OverflowError, binascii.Error):
        return None
    is_size = 0 < width <= _MOST_PIXELS and 0 < height <= _MOST_PIXELS
    if not data.startswith(_JPEG) or len(data) > MOST_PICTURE_BYTES or not is_size:
        return None
    image: Any = get_message(COMPRESSED_IMAGE)(format="jpeg", data=data)
    # The matrices stay zero, which means that the camera is not calibrated.
    info: Any = get_message(CAMERA_INFO)(width=width, height=height)
    for message in (image, info):
        message.header.stamp, message.header.frame_id = stamp, frame_id
    return Picture(image, info)


def level(reading: Sequence[Any]) -> Any:
    """Return the level of a microphone, from 0 (silence) to 1 (the loudest that it can measure)."""
    found = _numbers(reading, 1)
    if found is None or math.isnan(found[0]):
        return None
    message: Any = get_message(FLOAT32)()
    message.data = max(0.0, min(1.0, found[0]))
    return message


def imu(reading: Sequence[Any], stamp: Any, frame_id: str) -> Any:
    """Return the message of a phone's motion sensors.

    The axes are those of the phone: x to the right of the screen, y to its top, z out of it. The
    orientation is relative to east, north and up.

    Args:
        reading: Alpha, beta and gamma in degrees, the acceleration with gravity and without it in
            m/s^2, and the turn rates about x, y and z in degrees/s. Browsers call these alpha, beta
            and gamma too, but they are about other axes than the angles of these names. A value
            that is missing is None.
        stamp: The stamp.
        frame_id: The frame of the phone.
    """
    found = _numbers(reading, 12)
    if found is None:
        return None
    angles, whole, without, rates = (found[at : at + 3] for at in range(0, 12, 3))
    message: Any = get_message(IMU)()
    message.header.stamp, message.header.frame_id = stamp, frame_id
    known = [_is_known(part) for part in (angles, rates, whole)]
    if not any(known):
        return None
    if known[0]:
        x, y, z, w = _quaternion(angles)
        message.orientation = type(message.orientation)(x=x, y=y, z=z, w=w)
    if known[1]:
        _fill(message.angular_velocity, [math.radians(rate) for rate in rates])
    if known[2]:
        _fill(message.linear_acceleration, _acceleration(whole, without, angles))
    for name, is_known in zip(_MEASURED, known, strict=True):
        covariance = [0.0] * 9  # zeros: it is measured, and nobody knows how well
        covariance[0] = 0.0 if is_known else _NO_DATA
        setattr(message, f"{name}_covariance", covariance)
    return message


def fix(reading: Sequence[Any], stamp: Any, frame_id: str) -> Any:
    """Return the message of a position.

    Args:
        reading: Latitude and longitude in degrees, height in m, and the accuracies of the position
            and of the height in m. A height that is missing is None. An empty list means that the
            browser has no position now.
        stamp: The stamp.
        frame_id: The frame of the receiver.
    """
    message: Any = get_message(NAV_SAT_FIX)()
    message.header.stamp, message.header.frame_id = stamp, frame_id
    status = message.status
    if reading == []:
        status.status = status.STATUS_NO_FIX
        message.latitude = message.longitude = message.altitude = math.nan
        return message
    found = _numbers(reading, 5)
    if found is None or math.isnan(found[0] + found[1] + found[3]):
        return None
    latitude, longitude, altitude, accuracy_m, height_accuracy_m = found
    if abs(latitude) > 90 or abs(longitude) > 180:
        return None
    status.status = status.STATUS_FIX
    message.latitude, message.longitude, message.altitude = latitude, longitude, altitude
    flat = _variance(accuracy_m, _DEVIATIONS_IN_PLANE)
    is_height_known = not math.isnan(altitude + height_accuracy_m)
    height = _variance(height_accuracy_m, _DEVIATIONS_IN_HEIGHT)
    message.position_covariance = [
        *(flat, 0.0, 0.0),
        *(0.0, flat, 0.0),
        *(0.0, 0.0, height if is_height_known else _UNKNOWN_HEIGHT_M2),
    ]
    message.position_covariance_type = message.COVARIANCE_TYPE_APPROXIMATED
    return message


def _variance(accuracy_m: float, deviations: float) -> float:
    deviation_m = accuracy_m / deviations
    return deviation_m * deviation_m  # with `** 2`, a huge number would be an error


def _numbers(reading: Sequence[Any], count: int) -> list[float] | None:
    """Return numbers, with NaN for None. Return None if the reading has something else."""
    try:
        found = [math.nan if value is None else float(value) for value in reading]
    except (TypeError, ValueError, OverflowError):
        return None
    return found if len(found) == count and not any(map(math.isinf, found)) else None


def _is_known(values: Sequence[float]) -> bool:
    return not any(map(math.isnan, values))


def _fill(vector: Any, values: Sequence[float]) -> None:
    vector.x, vector.y, vector.z = values


def _quaternion(angles: Sequence[float]) -> tuple[float, float, float, float]:
    """Return x, y, z and w of turns about z (alpha), the new x (beta) and the new y (gamma)."""
    halves = [math.radians(angle) / 2 for angle in angles]
    (cz, cx, cy), (sz, sx, sy) = map(math.cos, halves), map(math.sin, halves)
    return (
        cz * sx * cy - sz * cx * sy,
        cz * cx * sy + sz * sx * cy,
        sz * cx * cy + cz * sx * sy,
        cz * cx * cy - sz * sx * sy,
    )


def _acceleration(
    whole: Sequence[float], without: Sequence[float], angles: Sequence[float]
) -> list[float]:
    """Return the acceleration with gravity: a phone that lies still has +9.81 upwards.

    Browsers on iOS give all accelerations with the other sign. The orientation shows this, because
    it says where up is.
    """
    if not _is_known(angles):
        return list(whole)
    _, beta, gamma = map(math.radians, angles)
    up = (-math.cos(beta) * math.sin(gamma), math.sin(beta), math.cos(beta) * math.cos(gamma))
    moved = without if _is_known(without) else (0.0, 0.0, 0.0)
    gravity = [one - other for one, other in zip(whole, moved, strict=True)]
    is_upwards = sum(one * other for one, other in zip(gravity, up, strict=True)) >= 0
    return list(whole) if is_upwards else [-value for value in whole]
