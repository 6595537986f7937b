"""Managed nodes: other programs configure them, activate them, deactivate them and shut them down.

    from std_msgs.msg import String
    from zbot.lifecycle import LifecycleNode, TransitionCallbackReturn

    class Talker(LifecycleNode):
        def on_configure(self, state):
            self.publisher = self.create_lifecycle_publisher(String, "chatter", 10)
            return TransitionCallbackReturn.SUCCESS

`zbot lifecycle set /talker configure` runs the callback. The publisher publishes after
`zbot lifecycle set /talker activate`.
"""

from zbot.lifecycle.errors import CallbackReturnError as CallbackReturnError
from zbot.lifecycle.errors import NotAManagedEntityError as NotAManagedEntityError
from zbot.lifecycle.errors import NotANodeError as NotANodeError
from zbot.lifecycle.managed_entity import LifecyclePublisher as LifecyclePublisher
from zbot.lifecycle.managed_entity import ManagedEntity as ManagedEntity
from zbot.lifecycle.managed_entity import SimpleManagedEntity as SimpleManagedEntity
from zbot.lifecycle.node import LifecycleNode as LifecycleNode
from zbot.lifecycle.node import LifecycleNodeMixin as LifecycleNodeMixin
from zbot.lifecycle.state_machine import LifecycleState as LifecycleState
from zbot.lifecycle.state_machine import StateMachine as StateMachine
from zbot.lifecycle.state_machine import TransitionCallbackReturn as TransitionCallbackReturn
from zbot.lifecycle.state_machine import TransitionNotPossibleError as TransitionNotPossibleError

# rclpy's short names.
Node = LifecycleNode
NodeMixin = LifecycleNodeMixin
State = LifecycleState
Publisher = LifecyclePublisher
