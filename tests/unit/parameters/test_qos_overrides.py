"""Tests of policies as values of parameters."""

from __future__ import annotations

import pytest

from zbot.parameters.qos_overrides import policy_parameter
from zbot.qos import DurabilityPolicy, QoSPolicyKind, QoSProfile
from zbot.time import Duration


@pytest.mark.parametrize(
    ("policy", "expected"),
    [
        (QoSPolicyKind.HISTORY, "keep_last"),
        (QoSPolicyKind.DEPTH, 7),
        (QoSPolicyKind.DEADLINE, 2),
        (QoSPolicyKind.AVOID_ROS_NAMESPACE_CONVENTIONS, False),
    ],
)
def test_a_policy_has_the_value_of_a_parameter(policy: QoSPolicyKind, expected: object) -> None:
    profile = QoSProfile(depth=7, deadline=Duration(nanoseconds=2))
    assert policy_parameter(profile, policy) == expected


def test_an_unknown_policy_has_no_value() -> None:
    profile = QoSProfile(depth=7, durability=DurabilityPolicy.UNKNOWN)
    with pytest.raises(ValueError, match="the durability is UNKNOWN"):
        policy_parameter(profile, QoSPolicyKind.DURABILITY)
