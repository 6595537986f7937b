"""Rule for the QoS profile of a subscription to a topic whose publishers are not known in advance.

DDS connects a subscription only to publishers that offer at least what the subscription requests.
So the rule of ROS 2's `ros2 topic echo`, `ros2 bag record` and topic_tools requests the most that
all publishers offer: it is reliable if all of them are reliable, and transient local if all of them
are transient local. A transient local subscription also receives messages that were sent before.

A topic without publishers has nothing to adapt to. Then ROS 2's programs differ, so the caller
gives the profile: `echo` requests best effort, which fits each publisher that may come, and
`record` requests reliable, because a recording should not lose messages.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data

if TYPE_CHECKING:
    from collections.abc import Sequence


def profile_to_show(offered: Sequence[QoSProfile], depth: int = 0) -> QoSProfile:
    """Return the profile of a program that shows messages to a person, as `ros2 topic echo` does.

    See `profile_to_subscribe`. Without publishers, the profile is `sensor_data`.

    Args:
        offered: The profiles of the topic's publishers.
        depth: Messages that may wait. The profile `sensor_data` lets 5 messages wait.
    """
    profile = QoSProfile(
        depth=depth or qos_profile_sensor_data.depth, reliability=ReliabilityPolicy.BEST_EFFORT
    )
    return profile_to_subscribe(offered, profile)


def profile_to_record(offered: Sequence[QoSProfile], depth: int) -> QoSProfile:
    """Return the profile of a program that keeps messages or passes them on.

    See `profile_to_subscribe`. Without publishers, the profile is reliable.
    """
    return profile_to_subscribe(offered, QoSProfile(depth=depth))


def profile_to_subscribe(offered: Sequence[QoSProfile], profile: QoSProfile) -> QoSProfile:
    """Change a profile so that it is compatible with all publishers of a topic, and return it.

    A transient local profile has room for all messages that one publisher keeps.

    Args:
        offered: The profiles of the publishers. Without publishers, nothing is changed.
        profile: The profile for a topic without publishers.
    """
    if not offered:
        return profile
    is_reliable = all(offer.reliability is ReliabilityPolicy.RELIABLE for offer in offered)
    is_kept = all(offer.durability is DurabilityPolicy.TRANSIENT_LOCAL for offer in offered)
    profile.reliability = (
        ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT
    )
    profile.durability = DurabilityPolicy.TRANSIENT_LOCAL if is_kept else DurabilityPolicy.VOLATILE
    if is_kept:
        profile.depth = max(profile.depth, *(offer.depth for offer in offered))
    return profile
