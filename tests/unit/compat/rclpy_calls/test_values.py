"""Tests of classes whose attributes are only read, and that no class is left out."""

from __future__ import annotations

import enum
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
import rclpy
from rclpy.duration import Duration
from rclpy.lifecycle import State
from rclpy.subscription_content_filter_options import ContentFilterOptions
from rclpy.waitable import NumberOfEntities

from tests.unit.compat.rclpy_calls.conftest import present
from tests.unit.compat.rclpy_table import ANNOTATIONS, NAMES, find

if TYPE_CHECKING:
    from collections.abc import Callable


#: Classes whose attributes are only read, without a test of their own.
VALUES: dict[str, Callable[[], Any]] = {
    "rclpy.clock.TimeJump": lambda: rclpy.clock.TimeJump(
        rclpy.clock.ClockChange.ROS_TIME_ACTIVATED, Duration()
    ),
    "rclpy.executors.TimeoutObject": lambda: rclpy.executors.TimeoutObject(1.0),
    "rclpy.impl.rcutils_logger.LoggingFilter": lambda: rclpy.impl.rcutils_logger.LoggingFilter,
    "rclpy.impl.rcutils_logger.Once": lambda: rclpy.impl.rcutils_logger.Once,
    "rclpy.impl.rcutils_logger.SkipFirst": lambda: rclpy.impl.rcutils_logger.SkipFirst,
    "rclpy.impl.rcutils_logger.Throttle": lambda: rclpy.impl.rcutils_logger.Throttle,
    "rclpy.lifecycle.node.LifecycleState": lambda: State("active", 3),
    "rclpy.qos.QoSPolicyEnum": lambda: rclpy.qos.ReliabilityPolicy.RELIABLE,
    "rclpy.qos_overriding_options.QoSOverridingOptions": lambda: (
        rclpy.qos_overriding_options.QoSOverridingOptions([])
    ),
    "rclpy.subscription_content_filter_options.ContentFilterOptions": lambda: ContentFilterOptions(
        "data = 'a'", []
    ),
    "rclpy.topic_endpoint_info.TopicEndpointInfo": rclpy.topic_endpoint_info.TopicEndpointInfo,
    "rclpy.type_hash.TypeHash": rclpy.type_hash.TypeHash,
    "rclpy.waitable.NumberOfEntities": NumberOfEntities,
}


@pytest.mark.parametrize("path", VALUES)
def test_values(path: str) -> None:
    value = VALUES[path]()
    for member in present(path):
        getattr(value, member)


def test_no_class_with_members_is_left_out() -> None:
    modules = Path(__file__).parent.glob("test_*.py")
    source = "".join(path.read_text(encoding="utf-8") for path in modules)
    classes = {
        f"{module}.{name}"
        for module, names in NAMES.items()
        for name in names
        if isinstance(find(module, name), type)
        and not isinstance(find(module, name), enum.EnumMeta)  # the page itself says their values
        and present(f"{module}.{name}")
    }
    assert {path for path in classes - ANNOTATIONS if f'"{path}"' not in source} == set()
