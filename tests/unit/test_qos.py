from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

import pytest

from zbot import qos
from zbot.errors import (
    ArgumentTypeError,
    InvalidQoSProfileError,
    UnknownQoSKeyError,
    WrongTypeError,
)
from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    PlainQoSProfile,
    QoSCompatibility,
    QoSPolicyEnum,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
    as_profile,
    qos_check_compatible,
    qos_policy_name_from_kind,
    qos_profile_sensor_data,
)
from zbot.time import Duration

if TYPE_CHECKING:
    from collections.abc import Callable


def test_a_depth_alone_keeps_the_last_messages() -> None:
    profile = QoSProfile(depth=7)
    assert (profile.history, profile.depth) == (HistoryPolicy.KEEP_LAST, 7)
    assert (profile.reliability, profile.durability) == (
        ReliabilityPolicy.RELIABLE,
        DurabilityPolicy.VOLATILE,
    )


def test_keep_all_needs_no_depth() -> None:
    assert QoSProfile(history=HistoryPolicy.KEEP_ALL).depth == 10


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        ({}, "give it a depth"),
        ({"history": HistoryPolicy.KEEP_LAST}, "KEEP_LAST needs a depth"),
        ({"depth": -1}, "greater than or equal to zero, not -1"),
        ({"depth": 1, "reliability": 99}, "reliability must be a ReliabilityPolicy, not 99"),
        ({"history": 10}, "history must be a HistoryPolicy, not 10"),
    ],
)
def test_an_incomplete_or_impossible_profile_is_refused(
    arguments: dict[str, Any], reason: str
) -> None:
    with pytest.raises(InvalidQoSProfileError, match=reason):
        QoSProfile(**arguments)


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        ({"depth": "a"}, "depth must be an integer, not str: 'a'"),
        ({"depth": True}, "depth must be an integer, not bool"),
        ({"depth": 1, "lifespan": 3}, "lifespan must be a Duration, not int: 3"),
        (
            {"depth": 1, "reliability": "best-effort"},
            "reliability must be a ReliabilityPolicy.BEST_EFFORT, not str: 'best-effort'",
        ),
        (
            {"depth": 1, "reliability": "fast"},
            "reliability must be a ReliabilityPolicy, not str: 'fast'",
        ),
        ({"depth": 1, "avoid_ros_namespace_conventions": 1}, "must be a bool"),
    ],
)
def test_a_policy_of_another_type_is_refused(arguments: dict[str, Any], reason: str) -> None:
    with pytest.raises(ArgumentTypeError, match=reason):
        QoSProfile(**arguments)


def test_policies_can_be_set_and_are_checked() -> None:
    profile = QoSProfile(depth=1)
    profile.reliability = 2
    profile.deadline = Duration(seconds=1)
    assert profile.reliability is ReliabilityPolicy.BEST_EFFORT
    assert profile.deadline == Duration(seconds=1)
    with pytest.raises(ArgumentTypeError):
        profile.deadline = 1  # type: ignore[assignment]  # pyright: ignore[reportAttributeAccessIssue]


def test_a_depth_of_zero_warns_at_the_caller() -> None:
    with pytest.warns(
        UserWarning, match="A zero depth with KEEP_LAST doesn't make sense"
    ) as caught:
        QoSProfile(depth=0)
    assert caught[0].filename == __file__


def test_profiles_are_compared_by_value() -> None:
    assert QoSProfile(depth=1) == QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=1)
    assert QoSProfile(depth=1) != QoSProfile(depth=2)
    assert QoSProfile(depth=1) != 1
    assert copy.deepcopy(qos_profile_sensor_data) == qos_profile_sensor_data


def test_str_is_that_of_ros() -> None:
    assert str(QoSProfile(depth=10)) == (
        "QoSProfile(history=1, depth=10, reliability=1, durability=2, lifespan=0 nanoseconds, "
        "deadline=0 nanoseconds, liveliness=0, liveliness_lease_duration=0 nanoseconds, "
        "avoid_ros_namespace_conventions=False)"
    )


def test_repr_names_the_policies() -> None:
    text = repr(qos_profile_sensor_data)
    assert text.startswith("QoSProfile(history=KEEP_LAST, depth=5, reliability=BEST_EFFORT")


@pytest.mark.parametrize(
    ("policy", "keys"),
    [
        (HistoryPolicy, ["system_default", "keep_last", "keep_all", "unknown"]),
        (
            LivelinessPolicy,
            ["system_default", "automatic", "manual_by_topic", "unknown", "best_available"],
        ),
    ],
)
def test_short_keys_are_accepted(policy: type[QoSPolicyEnum], keys: list[str]) -> None:
    assert policy.short_keys() == keys
    assert [policy(policy.get_from_short_key(key)).short_key for key in keys] == keys


def test_a_short_key_in_capitals_works() -> None:
    assert ReliabilityPolicy.get_from_short_key("BEST_effort") == 2


@pytest.mark.parametrize("kind", [ReliabilityPolicy, QoSPresetProfiles])
def test_an_unknown_short_key_lists_the_known_ones(kind: Any) -> None:
    with pytest.raises(UnknownQoSKeyError) as caught:
        kind.get_from_short_key("relaible")
    assert "has no 'relaible': use one of " in str(caught.value)
    assert isinstance(caught.value, KeyError)


def test_old_policy_names_still_work() -> None:
    old = qos.QoSReliabilityPolicy.RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT
    assert old is ReliabilityPolicy.BEST_EFFORT


# Preset, history, depth, reliability, durability, liveliness: the numbers of ROS 2's rmw.
@pytest.mark.parametrize(
    ("preset", "numbers"),
    [
        ("unknown", (3, 0, 3, 3, 4)),
        ("default", (1, 10, 1, 2, 0)),
        ("system_default", (0, 0, 0, 0, 0)),
        ("sensor_data", (1, 5, 2, 2, 0)),
        ("services_default", (1, 10, 1, 2, 0)),
        ("parameters", (1, 1000, 1, 2, 0)),
        ("parameter_events", (1, 1000, 1, 2, 0)),
        ("action_status_default", (1, 1, 1, 1, 0)),
        ("best_available", (1, 10, 4, 4, 5)),
        ("rosout_default", (1, 1000, 1, 1, 0)),
    ],
)
def test_presets_are_those_of_ros(preset: str, numbers: tuple[int, ...]) -> None:
    profile = QoSPresetProfiles.get_from_short_key(preset)
    assert (
        profile.history,
        profile.depth,
        profile.reliability,
        profile.durability,
        profile.liveliness,
    ) == numbers
    assert profile == getattr(qos, f"qos_profile_{preset}")


def test_rosout_lifespan_is_ten_seconds() -> None:
    assert QoSPresetProfiles.ROSOUT_DEFAULT.value.lifespan == Duration(seconds=10)


SECOND, MINUTE = Duration(seconds=1), Duration(seconds=60)
AUTOMATIC = LivelinessPolicy.AUTOMATIC


@pytest.mark.parametrize(
    ("offered", "requested", "reason"),
    [
        ({}, {}, ""),
        ({"reliability": ReliabilityPolicy.BEST_EFFORT}, {}, "reliability is BEST_EFFORT and"),
        ({}, {"reliability": ReliabilityPolicy.BEST_EFFORT}, ""),
        ({}, {"durability": DurabilityPolicy.TRANSIENT_LOCAL}, "durability is VOLATILE and"),
        ({"durability": DurabilityPolicy.TRANSIENT_LOCAL}, {}, ""),
        ({}, {"liveliness": LivelinessPolicy.MANUAL_BY_TOPIC}, "liveliness is AUTOMATIC and"),
        ({}, {"deadline": SECOND}, "subscription deadline is shorter than publisher deadline;"),
        ({"deadline": MINUTE}, {"deadline": SECOND}, "subscription deadline is shorter"),
        ({"deadline": SECOND}, {"deadline": MINUTE}, ""),
        ({"deadline": SECOND}, {}, ""),
        (
            {"liveliness_lease_duration": MINUTE},
            {"liveliness_lease_duration": SECOND},
            "subscription liveliness_lease_duration is shorter",
        ),
    ],
)
def test_profiles_are_compared_by_the_rules_of_dds(
    offered: dict[str, Any], requested: dict[str, Any], reason: str
) -> None:
    profiles = (QoSProfile(**{"depth": 1, "liveliness": AUTOMATIC, **each})
                for each in (offered, requested))  # fmt: skip
    result, text = qos_check_compatible(*profiles)
    assert result is (QoSCompatibility.ERROR if reason else QoSCompatibility.OK)
    assert reason in text
    assert text.startswith("ERROR: ") is bool(reason)


def test_a_system_default_may_be_incompatible() -> None:
    offer = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT, liveliness=AUTOMATIC)
    request = QoSProfile(
        depth=1, reliability=ReliabilityPolicy.SYSTEM_DEFAULT, liveliness=AUTOMATIC
    )
    result, reason = qos_check_compatible(offer, request)
    assert result is QoSCompatibility.WARNING
    assert reason.startswith("WARNING: publisher reliability is BEST_EFFORT and subscription")
    assert qos_check_compatible(request, offer) == (QoSCompatibility.OK, "")


def test_policies_can_be_exported_and_imported() -> None:
    picky = QoSProfile(history=HistoryPolicy.KEEP_ALL, depth=7, lifespan=Duration(seconds=5))
    policies = picky.get_c_qos_profile().to_dict()
    assert QoSProfile(**policies) == picky
    sensor = PlainQoSProfile.predefined("qos_profile_sensor_data")
    assert QoSProfile(**sensor.to_dict()) == qos_profile_sensor_data


def test_policy_kinds_have_names() -> None:
    assert qos_policy_name_from_kind(16) == "RELIABILITY"


def test_a_number_in_place_of_a_profile_is_its_depth() -> None:
    assert as_profile(3) == QoSProfile(depth=3)
    assert as_profile(qos_profile_sensor_data) is qos_profile_sensor_data
    with pytest.raises(WrongTypeError, match="Expected QoSProfile or int, the depth of a queue"):
        as_profile("10")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (
            lambda: QoSProfile(ReliabilityPolicy.BEST_EFFORT),
            (
                "history is ReliabilityPolicy.BEST_EFFORT, which counts as HistoryPolicy.KEEP_ALL: "
                "write reliability=ReliabilityPolicy.BEST_EFFORT in a QoSProfile"
            ),
        ),
        (
            lambda: QoSProfile(depth=1, durability=ReliabilityPolicy.BEST_EFFORT),
            "counts as DurabilityPolicy.VOLATILE: write reliability=",
        ),
        (lambda: as_profile(ReliabilityPolicy.BEST_EFFORT), "which counts as the depth 2: write"),
    ],
)
def test_a_member_of_another_policy_is_told(make: Callable[[], object], text: str) -> None:
    with pytest.warns(UserWarning, match=text):
        make()
