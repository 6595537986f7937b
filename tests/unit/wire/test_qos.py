from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from zbot import qos
from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
)
from zbot.time import Duration, Infinite
from zbot.wire.qos import parse_qos, qos_text

LATCHED = DurabilityPolicy.TRANSIENT_LOCAL


# rmw_zenoh writes these texts for the same profiles.
@pytest.mark.parametrize(
    ("profile", "text"),
    [
        (qos.qos_profile_default, "::,10:,:,:,,"),
        (qos.qos_profile_services_default, "::,10:,:,:,,"),
        (qos.qos_profile_sensor_data, "2::,5:,:,:,,"),
        (QoSProfile(depth=42), "::,:,:,:,,"),
        (qos.qos_profile_system_default, "::,:,:,:,,"),
        (QoSProfile(history=HistoryPolicy.KEEP_ALL, depth=0), "::2,:,:,:,,"),
        (qos.qos_profile_action_status_default, ":1:,1:,:,:,,"),
        (qos.qos_profile_parameters, "::,1000:,:,:,,"),
        (qos.qos_profile_rosout_default, ":1:,1000:,:10,0:,,"),
        (QoSProfile(depth=10, deadline=Duration(seconds=0.1)), "::,10:0,100000000:,:,,"),
        (QoSProfile(depth=10, deadline=Infinite), "::,10:,:,:,,"),
        (qos.qos_profile_best_available, "::,10:,:,:,,"),
        (
            QoSProfile(
                depth=1,
                liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
                liveliness_lease_duration=Duration(seconds=2),
            ),
            "::,1:,:,:3,2,0",
        ),
    ],
)
def test_a_profile_becomes_the_text_of_rmw_zenoh(profile: QoSProfile, text: str) -> None:
    assert qos_text(profile) == text


def test_empty_components_are_the_defaults() -> None:
    profile = parse_qos("::,:,:,:,,")
    assert (profile.history, profile.depth) == (HistoryPolicy.KEEP_LAST, 42)
    assert profile.reliability is ReliabilityPolicy.RELIABLE
    assert profile.durability is DurabilityPolicy.VOLATILE
    assert profile.liveliness is LivelinessPolicy.AUTOMATIC
    assert profile.deadline == profile.lifespan == Infinite
    assert profile.liveliness_lease_duration == Infinite


def test_policies_of_a_later_version_are_unknown() -> None:
    profile = parse_qos("9:9:9,1:,:,:9,,:new")
    assert {profile.reliability.name, profile.durability.name, profile.history.name} == {"UNKNOWN"}
    assert profile.liveliness is LivelinessPolicy.UNKNOWN


@pytest.mark.parametrize(
    "text",
    [
        "",
        "::::",
        "::::::",
        "x::,1:,:,:,,",
        "::,-1:,:,:,,",
        "::,1:,:,:,",
        "::,1::,:,,",
        "::,²:,:,:,,",
    ],
)
def test_a_text_of_another_form_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="QoS"):
        parse_qos(text)


def test_a_very_long_number_is_rejected() -> None:
    with pytest.raises(ValueError, match="not a number"):
        parse_qos(f"::,{'9' * 5000}:,:,:,,")


durations = st.integers(min_value=1, max_value=2**63 - 2).map(lambda ns: Duration(nanoseconds=ns))


@given(
    profile=st.builds(
        QoSProfile,
        history=st.sampled_from([HistoryPolicy.KEEP_LAST, HistoryPolicy.KEEP_ALL]),
        depth=st.integers(min_value=1, max_value=10**6),
        reliability=st.sampled_from([ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT]),
        durability=st.sampled_from([DurabilityPolicy.VOLATILE, LATCHED]),
        deadline=durations,
        lifespan=durations,
        liveliness=st.sampled_from([LivelinessPolicy.AUTOMATIC, LivelinessPolicy.MANUAL_BY_TOPIC]),
        liveliness_lease_duration=durations,
    )
)
def test_any_definite_profile_round_trips(profile: QoSProfile) -> None:
    assert qos_text(parse_qos(qos_text(profile))) == qos_text(profile)


@given(st.text(alphabet=":,0123456789x", max_size=40))
def test_any_text_is_a_profile_or_a_value_error(text: str) -> None:
    try:
        profile = parse_qos(text)
    except ValueError:
        return
    assert isinstance(profile, QoSProfile)
