"""Tests of the messages that the panel Sensors makes of a browser's readings."""

from __future__ import annotations

import base64
import itertools
import math
from typing import Any

import pytest

from zbot.web.panels.sensors.browser_name import frame_of, full_topic, usual_name
from zbot.web.panels.sensors.sensor_kind import CAMERA, KINDS, MOTION, camera_info_topic
from zbot.web.panels.sensors.sensor_message import MOST_PICTURE_BYTES, fix, imu, level, picture
from zbot.web.panels.sensors.sensor_problem import sentence
from zbot.web.panels.sensors.sensor_publisher import RateLimit

from builtin_interfaces.msg import Time

STAMP = Time(sec=5)
FLAT = [0.0, 0.0, 0.0]
GRAVITY = [0.0, 0.0, 9.81]
NOTHING: list[float | None] = [None, None, None]
JPEG = b"\xff\xd8\xff\xe0 and so on"


def text(data: bytes) -> str:
    return base64.b64encode(data).decode()


def reading(*parts: list[Any]) -> list[Any]:
    return list(itertools.chain(*parts))


HALF = math.sqrt(0.5)


@pytest.mark.parametrize(
    ("angles", "expected"),
    [
        ([0, 0, 0], (0, 0, 0, 1)),
        ([90, 0, 0], (0, 0, HALF, HALF)),  # turned to the left, as seen from above
        ([0, 90, 0], (HALF, 0, 0, HALF)),  # the top edge is up
        ([0, 0, 90], (0, HALF, 0, HALF)),  # the left edge is up
        ([180, 0, 0], (0, 0, 1, 0)),
    ],
)
def test_angles_of_a_browser_are_an_orientation_to_east_north_and_up(
    angles: list[float], expected: tuple[float, ...]
) -> None:
    found = imu(reading(angles, GRAVITY, FLAT, FLAT), STAMP, "phone_imu").orientation
    assert (found.x, found.y, found.z, found.w) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("beta", [-170, -60, 0, 35, 120])
@pytest.mark.parametrize("gamma", [-80, 0, 45])
def test_the_orientation_turns_the_gravity_of_a_phone_that_lies_still_upwards(
    beta: float, gamma: float
) -> None:
    b, g = math.radians(beta), math.radians(gamma)
    up = [-math.cos(b) * math.sin(g), math.sin(b), math.cos(b) * math.cos(g)]
    measured = [9.81 * part for part in up]
    message = imu(reading([30, beta, gamma], measured, FLAT, FLAT), STAMP, "a")
    assert turned(message.orientation, measured) == pytest.approx((0, 0, 9.81), abs=1e-6)


def turned(q: Any, vector: list[float]) -> tuple[float, float, float]:
    """Return a vector, turned by a quaternion."""
    x, y, z = vector
    tx, ty, tz = (2 * one for one in (q.y * z - q.z * y, q.z * x - q.x * z, q.x * y - q.y * x))
    return (
        x + q.w * tx + q.y * tz - q.z * ty,
        y + q.w * ty + q.z * tx - q.x * tz,
        z + q.w * tz + q.x * ty - q.y * tx,
    )


def test_turn_rates_are_about_x_y_and_z_in_radians() -> None:
    message = imu(reading(FLAT, GRAVITY, FLAT, [180, -90, 18]), STAMP, "a")
    rate = message.angular_velocity
    assert (rate.x, rate.y, rate.z) == pytest.approx((math.pi, -math.pi / 2, math.pi / 10))


def test_the_accelerations_of_ios_get_the_sign_of_ros() -> None:
    message = imu(reading(FLAT, [0.5, 0, -9.81], [0.5, 0, 0], FLAT), STAMP, "a")
    found = message.linear_acceleration
    assert (found.x, found.y, found.z) == pytest.approx((-0.5, 0, 9.81))


def test_a_phone_that_is_thrown_down_keeps_its_sign() -> None:
    message = imu(reading(FLAT, [0, 0, -2.0], [0, 0, -11.81], FLAT), STAMP, "a")
    assert message.linear_acceleration.z == pytest.approx(-2.0)


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        (reading(FLAT, GRAVITY, FLAT, FLAT), (0, 0, 0)),
        (reading(FLAT, NOTHING, NOTHING, NOTHING), (0, -1, -1)),
        (reading(NOTHING, GRAVITY, NOTHING, NOTHING), (-1, -1, 0)),
        (reading([None, 1, 2], NOTHING, NOTHING, FLAT), (-1, 0, -1)),
    ],
)
def test_what_is_not_measured_has_the_covariance_minus_one(
    values: list[Any], expected: tuple[float, ...]
) -> None:
    message = imu(values, STAMP, "a")
    covariances = (
        message.orientation_covariance,
        message.angular_velocity_covariance,
        message.linear_acceleration_covariance,
    )
    assert tuple(one[0] for one in covariances) == expected


def test_a_position_has_variances_of_its_accuracy() -> None:
    message = fix([46.5, 6.6, 400.0, 24.477, 19.6], STAMP, "phone_gps")
    assert (message.latitude, message.longitude, message.altitude) == (46.5, 6.6, 400.0)
    assert [message.position_covariance[at] for at in (0, 4, 8)] == pytest.approx([100] * 3)
    assert message.position_covariance_type == message.COVARIANCE_TYPE_APPROXIMATED
    assert message.status.status == message.status.STATUS_FIX
    assert message.header.frame_id == "phone_gps"


def test_an_unknown_height_is_nan_and_uncertain() -> None:
    message = fix([46.5, 6.6, None, 10, None], STAMP, "a")
    assert math.isnan(message.altitude)
    assert message.position_covariance[8] == 1e6


def test_a_lost_position_is_no_fix() -> None:
    message = fix([], STAMP, "a")
    assert message.status.status == message.status.STATUS_NO_FIX
    assert math.isnan(message.latitude)
    assert message.position_covariance_type == message.COVARIANCE_TYPE_UNKNOWN


def test_a_picture_and_its_info_have_one_header() -> None:
    found = picture([text(JPEG), 640, 480], STAMP, "phone_camera_optical")
    assert found is not None
    assert bytes(found.image.data) == JPEG
    assert found.image.header == found.info.header
    assert (found.info.width, found.info.height, found.info.k[0]) == (640, 480, 0)


@pytest.mark.parametrize(
    "wrong",
    [
        [],
        None,
        5,
        "abc",
        [text(b"GIF89a"), 640, 480],
        ["%", 640, 480],
        [5, 640, 480],
        [text(JPEG), 0, 480],
        [text(JPEG), math.inf, 480],
        [text(JPEG), "a", 480],
        [text(JPEG + bytes(MOST_PICTURE_BYTES)), 640, 480],
    ],
)
def test_a_wrong_picture_is_left_out(wrong: Any) -> None:
    assert picture(wrong, STAMP, "a") is None


@pytest.mark.parametrize("wrong", [None, 5, [], ["a"] * 12, [1] * 11, [math.inf] * 12, [[]] * 12])
def test_wrong_values_are_left_out(wrong: Any) -> None:
    assert imu(wrong, STAMP, "a") is None
    assert level(wrong) is None
    if wrong != []:
        assert fix(wrong, STAMP, "a") is None


def test_a_motion_without_any_value_is_left_out() -> None:
    assert imu([None] * 12, STAMP, "a") is None


@pytest.mark.parametrize("wrong", [[91, 0, 0, 1, 1], [0, 181, 0, 1, 1], [None, 0, 0, 1, 1]])
def test_a_place_that_is_not_on_earth_is_left_out(wrong: list[Any]) -> None:
    assert fix(wrong, STAMP, "a") is None


def test_a_level_is_from_0_to_1() -> None:
    assert [level([value]).data for value in (-1, 0.5, 3)] == [0, 0.5, 1]


def test_readings_above_the_limit_are_left_out() -> None:
    now_s = 0.0
    limit = RateLimit(5, lambda: now_s)
    assert [limit.allows() for _ in range(12)] == [True] * 10 + [False] * 2
    now_s = 0.4
    assert [limit.allows() for _ in range(3)] == [True, True, False]


def test_topics_are_relative_to_the_name_of_the_browser() -> None:
    assert full_topic("ana", "imu") == "/ana/imu"
    assert full_topic("/ana/", "imu") == "/ana/imu"
    assert full_topic("ana", "/imu") == "/imu"
    assert frame_of("class/ana-1", MOTION) == "class_ana_1_imu"


def test_the_info_of_a_camera_is_beside_its_images() -> None:
    assert camera_info_topic(full_topic("ana", CAMERA.topic)) == "/ana/camera/camera_info"
    assert camera_info_topic("/image") == "/camera_info"


def test_phones_and_laptops_have_different_names() -> None:
    android = "Mozilla/5.0 (Linux; Android 10; K) Chrome/150.0.0.0 Mobile Safari/537.36"
    assert usual_name(android) == "phone"
    assert usual_name("Mozilla/5.0 (X11; Linux x86_64) Chrome/150.0.0.0") == "laptop"


def test_each_problem_is_one_sentence_about_its_sensor() -> None:
    for kind in KINDS:
        assert sentence(kind, "absent").startswith("This device has no ")
        assert sentence(kind, None) == sentence(kind, "{}") == "The browser refuses it."
