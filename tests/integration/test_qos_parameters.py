"""Tests of quality of service set by parameters, also with rclpy's own function."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

import pytest

import zbot
import zbot.compat
from zbot.errors import UnknownQoSKeyError
from zbot.parameters.errors import InvalidQosOverridesError
from zbot.parameters.parameter import Parameter
from zbot.parameters.qos_overrides import QoSOverridingOptions
from zbot.qos import QoSPolicyKind, QoSProfile, ReliabilityPolicy

from rcl_interfaces.msg import SetParametersResult
from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext


def test_a_profile_is_changed_by_its_parameters(make_context: Callable[[], zbot.Context]) -> None:
    assert zbot.compat
    declare = importlib.import_module("rclpy.qos_overriding_options")._declare_qos_parameters
    depth = Parameter("qos_overrides./scan.subscription.depth", value=3)
    node = zbot.Node("tuned", context=make_context(), parameter_overrides=[depth])
    profile = QoSProfile(depth=10)
    options = QoSOverridingOptions.with_default_policies()
    declare(zbot.Subscription, node, "/scan", profile, options)
    assert profile.depth == 3
    assert node.get_parameter("qos_overrides./scan.subscription.history").value == "keep_last"


def test_parameters_override_quality_of_service(make_context: MakeContext) -> None:
    node = zbot.Node(
        "tuned",
        context=make_context(),
        parameter_overrides=[
            Parameter("qos_overrides./scan.publisher.depth", value=3),
            Parameter("qos_overrides./scan.subscription_left.reliability", value="best_effort"),
        ],
    )
    asked = QoSProfile(depth=10)
    publisher = node.create_publisher(
        String, "scan", asked, qos_overriding_options=QoSOverridingOptions.with_default_policies()
    )
    subscription = node.create_subscription(
        String,
        "scan",
        print,
        asked,
        qos_overriding_options=QoSOverridingOptions(
            [QoSPolicyKind.RELIABILITY, QoSPolicyKind.LIFESPAN, QoSPolicyKind.DEADLINE],
            entity_id="left",
        ),
    )
    assert (publisher.qos_profile.depth, asked.depth) == (3, 10)
    assert subscription.qos_profile.reliability is ReliabilityPolicy.BEST_EFFORT
    names = sorted(node.get_parameters_by_prefix("qos_overrides"))
    assert names == [
        "/scan.publisher.depth",
        "/scan.publisher.history",
        "/scan.publisher.reliability",
        "/scan.subscription_left.deadline",
        "/scan.subscription_left.reliability",
    ]
    assert node.describe_parameter("qos_overrides./scan.publisher.depth").read_only


def test_invalid_quality_of_service_is_refused(make_context: MakeContext) -> None:
    wrong = [Parameter("qos_overrides./scan.publisher.reliability", value="relaible")]
    node = zbot.Node("tuned", context=make_context(), parameter_overrides=wrong)
    with pytest.raises(UnknownQoSKeyError, match="relaible"):
        node.create_publisher(
            String, "scan", 10, qos_overriding_options=QoSOverridingOptions.with_default_policies()
        )
    options = QoSOverridingOptions.with_default_policies(
        callback=lambda _: SetParametersResult(successful=False, reason="too deep")
    )
    with pytest.raises(InvalidQosOverridesError, match=r"subscription of /scan .*too deep"):
        node.create_subscription(String, "scan", print, 10, qos_overriding_options=options)
