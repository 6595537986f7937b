"""Profile of a subscription to a topic whose publishers are not known in advance."""

from __future__ import annotations

from zbot.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from zbot.remote.profiles import profile_to_record, profile_to_show, profile_to_subscribe

RELIABLE, BEST_EFFORT = ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT
KEPT, VOLATILE = DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.VOLATILE


def offer(
    reliability: ReliabilityPolicy = RELIABLE,
    durability: DurabilityPolicy = VOLATILE,
    depth: int = 10,
) -> QoSProfile:
    return QoSProfile(depth=depth, reliability=reliability, durability=durability)


def test_all_publishers_are_reliable_or_the_subscription_is_best_effort() -> None:
    for rule in (profile_to_show, profile_to_record):
        assert rule([offer(), offer()], 5).reliability is RELIABLE
        assert rule([offer(), offer(BEST_EFFORT)], 5).reliability is BEST_EFFORT
        assert rule([offer(BEST_EFFORT)], 5).reliability is BEST_EFFORT


def test_old_messages_come_only_if_all_publishers_keep_them() -> None:
    for rule in (profile_to_show, profile_to_record):
        assert rule([offer(durability=KEPT)], 5).durability is KEPT
        assert rule([offer(durability=KEPT), offer()], 5).durability is VOLATILE


def test_the_queue_has_room_for_all_kept_messages() -> None:
    many = [offer(durability=KEPT, depth=1), offer(durability=KEPT, depth=30)]
    assert profile_to_show(many).depth == 30
    assert profile_to_show(many, 100).depth == 100
    assert profile_to_record([offer(depth=30)], 10).depth == 10


def test_without_publishers_an_echo_is_best_effort_and_a_recording_is_reliable() -> None:
    assert (profile_to_show([]).reliability, profile_to_show([]).depth) == (BEST_EFFORT, 5)
    assert profile_to_record([], 10).reliability is RELIABLE
    assert profile_to_subscribe([], offer(durability=KEPT)).durability is KEPT
