"""Managed nodes."""

from zbot.compat.annotation import CallbackNames as CallbackNames
from zbot.compat.annotation import CreateLifecyclePublisherArgs as CreateLifecyclePublisherArgs
from zbot.compat.annotation import LifecycleNodeArgs as LifecycleNodeArgs
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.interfaces.type_support import check_is_valid_srv_type as check_is_valid_srv_type
from zbot.lifecycle import LifecycleState as LifecycleState
from zbot.lifecycle import TransitionCallbackReturn as TransitionCallbackReturn
from zbot.lifecycle.managed_entity import ManagedEntity as ManagedEntity
from zbot.lifecycle.node import LifecycleNode as LifecycleNode
from zbot.lifecycle.node import LifecycleNodeMixin as LifecycleNodeMixin
from zbot.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher
from zbot.log import Logger as RcutilsLogger
from zbot.node.node import Node as Node
from zbot.node.service import Service as Service
from zbot.qos import QoSProfile as QoSProfile
