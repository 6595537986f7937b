"""Listeners."""

from zbot.tf2.broadcaster import TF_STATIC_TOPIC as DEFAULT_STATIC_TF_TOPIC
from zbot.tf2.broadcaster import TF_TOPIC as DEFAULT_TF_TOPIC
from zbot.tf2.listener import TransformListener
