"""Managed nodes."""

from zbot.callback_group import CallbackGroup as CallbackGroup
from zbot.lifecycle import LifecycleState as LifecycleState
from zbot.lifecycle import TransitionCallbackReturn as TransitionCallbackReturn
from zbot.lifecycle.managed_entity import ManagedEntity as ManagedEntity
from zbot.lifecycle.node import LifecycleNode as LifecycleNode
from zbot.lifecycle.node import LifecycleNodeMixin as LifecycleNodeMixin
from zbot.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher
from zbot.log import Logger as RcutilsLogger
from zbot.node import Node as Node
from zbot.qos import QoSProfile as QoSProfile
from zbot.service import Service as Service
