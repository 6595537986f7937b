# Written by python -m zbot.compat.generator; do not edit.
"""Info about publishers and subscriptions."""

from zbot.compat.annotation import TypeHashDictionary
from zbot.graph.endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum, TypeHash
from zbot.qos import QoSHistoryPolicy, QoSPresetProfiles, QoSProfile

__all__ = [
    "QoSHistoryPolicy",
    "QoSPresetProfiles",
    "QoSProfile",
    "TopicEndpointInfo",
    "TopicEndpointTypeEnum",
    "TypeHash",
    "TypeHashDictionary",
]
