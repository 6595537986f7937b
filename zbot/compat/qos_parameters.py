"""Declaration of parameters that override a quality of service, as in rclpy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.node.publisher import Publisher
from zbot.parameters.qos_overrides import QoSOverridingOptions, override

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.node.subscription import Subscription
    from zbot.qos import QoSProfile


def declare_qos_parameters(
    entity_type: type[Publisher[Any] | Subscription[Any]],
    node: Node,
    topic_name: str,
    qos: QoSProfile,
    options: QoSOverridingOptions,
) -> None:
    """Declare the policies of a publisher or subscription as parameters.

    Write the values of the parameters into `qos`.

    Raises:
        InvalidQosOverridesError: The options' callback refuses the result.
    """
    entity = "publisher" if issubclass(entity_type, Publisher) else "subscription"
    override(node.handle.parameters, entity, topic_name, qos, options)
