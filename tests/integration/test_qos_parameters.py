"""Test of quality of service set by parameters, with rclpy's own function."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

import zbot
import zbot.compat
from zbot.parameters.parameter import Parameter
from zbot.parameters.qos_overrides import QoSOverridingOptions
from zbot.qos import QoSProfile

if TYPE_CHECKING:
    from collections.abc import Callable


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
