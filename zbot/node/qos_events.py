"""Kinds of QoS events, and the info that each event contains, as in rclpy."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TypeAlias


class QoSPublisherEventType(Enum):
    """Kinds of events of a publisher, with rclpy's names and numbers."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(Enum):
    """Kinds of events of a subscription, with rclpy's names and numbers."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


EventKind: TypeAlias = QoSPublisherEventType | QoSSubscriptionEventType


@dataclass(frozen=True)
class QoSCountInfo:
    """Number of events, in total and since the last info."""

    total_count: int
    total_count_change: int


class QoSOfferedDeadlineMissedInfo(QoSCountInfo):
    """A publisher sent nothing for a whole deadline period."""


class QoSRequestedDeadlineMissedInfo(QoSCountInfo):
    """A subscription got nothing for a whole deadline period."""


class QoSLivelinessLostInfo(QoSCountInfo):
    """A publisher did not assert its liveliness in time."""


class QoSMessageLostInfo(QoSCountInfo):
    """Messages were published but not received."""


class IncompatibleTypeInfo(QoSCountInfo):
    """Another node uses the topic with another type."""


@dataclass(frozen=True)
class QoSRequestedIncompatibleQoSInfo(QoSCountInfo):
    """Info of an event that never happens, because all profiles are compatible in zbot."""

    last_policy_kind: int


QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo


@dataclass(frozen=True)
class QoSMatchedInfo(QoSCountInfo):
    """Number of matched endpoints, in total and at present."""

    current_count: int
    current_count_change: int


QoSPublisherMatchedInfo = QoSMatchedInfo
QoSSubscriptionMatchedInfo = QoSMatchedInfo


@dataclass(frozen=True)
class QoSLivelinessChangedInfo:
    """Number of publishers that are alive, and number of publishers that are gone."""

    alive_count: int
    not_alive_count: int
    alive_count_change: int
    not_alive_count_change: int
