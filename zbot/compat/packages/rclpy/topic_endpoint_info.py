"""Who publishes and subscribes, and how."""

from zbot.graph import TopicEndpointInfo as TopicEndpointInfo
from zbot.qos import QoSHistoryPolicy as QoSHistoryPolicy
from zbot.qos import QoSPresetProfiles as QoSPresetProfiles
from zbot.qos import QoSProfile as QoSProfile
