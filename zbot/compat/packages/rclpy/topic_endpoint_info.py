"""Who publishes and subscribes, and how."""

from zbot.compat.annotation import TypeHashDictionary as TypeHashDictionary
from zbot.graph.endpoint_info import TopicEndpointInfo as TopicEndpointInfo
from zbot.graph.endpoint_info import TopicEndpointTypeEnum as TopicEndpointTypeEnum
from zbot.graph.endpoint_info import TypeHash as TypeHash
from zbot.qos import QoSHistoryPolicy as QoSHistoryPolicy
from zbot.qos import QoSPresetProfiles as QoSPresetProfiles
from zbot.qos import QoSProfile as QoSProfile
