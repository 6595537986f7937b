"""Publish the states of all joints of the hardware.

Type:       joint_state_broadcaster/JointStateBroadcaster
Publishes:  joint_states (sensor_msgs/JointState),
            dynamic_joint_states (control_msgs/DynamicJointState)
Parameters: joints and interfaces ([]: all of the hardware that is configured), extra_joints ([]),
            use_local_topics (false), use_urdf_to_filter (true), frame_id ("base_link"),
            map_interface_to_joint_state.position, .velocity, .effort
"""

from __future__ import annotations

import math

from zbot.libraries.robot_description.urdf import read_urdf
from zbot_nodes.control.controller import Controller, State

from control_msgs.msg import DynamicJointState, InterfaceValue
from sensor_msgs.msg import JointState

_KINDS = ("position", "velocity", "effort")
_DEPTH = 10


class JointStateBroadcaster(Controller):
    """Publishes the states of the joints in every update."""

    kind = "joint_state_broadcaster/JointStateBroadcaster"

    def configure(self) -> None:
        """Choose the interfaces."""
        prefix = "~/" if self.setting("use_local_topics", False) else ""
        self.frame = str(self.setting("frame_id", "base_link"))
        self.mapped = {
            kind: str(self.setting(f"map_interface_to_joint_state.{kind}", kind)) for kind in _KINDS
        }
        wanted, kinds = self.setting("joints", []), self.setting("interfaces", [])
        self.chosen = [f"{joint}/{kind}" for joint in wanted for kind in kinds]
        self.is_filtered = bool(self.setting("use_urdf_to_filter", True)) and not self.chosen
        self.more_joints = self.setting("extra_joints", [])
        self.publisher = self.create_publisher(JointState, f"{prefix}joint_states", _DEPTH)
        self.dynamic = self.create_publisher(
            DynamicJointState, f"{prefix}dynamic_joint_states", _DEPTH
        )

    def state_interfaces(self) -> list[str]:
        """Return the interfaces that the broadcaster publishes.

        Without parameters, these are the interfaces of the hardware that is configured when the
        broadcaster becomes active.
        """
        if self.state is State.ACTIVE:
            return [f"{joint}/{kind}" for joint, own in self.interfaces.items() for kind in own]
        closed = self.hardware.closed()
        names = [name for component in self.hardware.components for name in component.states]
        # If no hardware is configured, the manager refuses the activation and names a component.
        return self.chosen or [name for name in names if name not in closed] or names

    def activate(self) -> None:
        """Sort the interfaces that there are now by joint, in the order of the description."""
        names = self.state_interfaces()
        self.interfaces: dict[str, list[str]] = {}
        for name in names:
            joint, _, interface = name.rpartition("/")
            self.interfaces.setdefault(joint, []).append(interface)
        known = set(read_urdf(self.description).joints)
        self.shown = [
            joint
            for joint, own in self.interfaces.items()
            if set(own) & set(self.mapped.values()) and (joint in known or not self.is_filtered)
        ]
        self.extra = [joint for joint in self.more_joints if joint not in self.shown]

    def update(self, period_s: float) -> None:
        """Publish the present states. A value that the hardware does not have is NaN."""
        del period_s
        stamp, states = self.get_clock().now().to_msg(), self.hardware.states
        message = JointState(name=[*self.shown, *self.extra])
        message.header.stamp, message.header.frame_id = stamp, self.frame
        for kind in _KINDS:
            own = [states.get(f"{joint}/{self.mapped[kind]}", math.nan) for joint in self.shown]
            setattr(message, kind, [*own, *(0.0 for _ in self.extra)])
        self.publisher.publish(message)
        dynamic = DynamicJointState(joint_names=list(self.interfaces))
        dynamic.header.stamp, dynamic.header.frame_id = stamp, self.frame
        dynamic.interface_values = [
            InterfaceValue(interface_names=own, values=[states[f"{joint}/{kind}"] for kind in own])
            for joint, own in self.interfaces.items()
        ]
        self.dynamic.publish(dynamic)
