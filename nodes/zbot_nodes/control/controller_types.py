"""Table of the controllers that the controller manager can load."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot_nodes.control.diff_drive_controller import DiffDriveController
from zbot_nodes.control.forward_command_controller import (
    ForwardCommandController,
    JointGroupEffortController,
    JointGroupPositionController,
    JointGroupVelocityController,
    MultiInterfaceForwardCommandController,
    PassthroughController,
)
from zbot_nodes.control.gpio_controller import GpioCommandController
from zbot_nodes.control.gripper_controller import (
    GripperActionController,
    ParallelGripperActionController,
)
from zbot_nodes.control.joint_state_broadcaster import JointStateBroadcaster
from zbot_nodes.control.joint_trajectory_controller import JointTrajectoryController
from zbot_nodes.control.pid_controller import PidController
from zbot_nodes.control.sensor_broadcasters import (
    ForceTorqueSensorBroadcaster,
    IMUSensorBroadcaster,
    RangeSensorBroadcaster,
)
from zbot_nodes.control.steering_controllers import (
    AckermannSteeringController,
    BicycleSteeringController,
    TricycleSteeringController,
)

if TYPE_CHECKING:
    from zbot_nodes.control.controller import Controller

#: The classes of controllers by the names of ROS 2's plugins.
TYPES: dict[str, type[Controller]] = {
    controller.kind: controller
    for controller in (
        AckermannSteeringController,
        BicycleSteeringController,
        DiffDriveController,
        ForceTorqueSensorBroadcaster,
        ForwardCommandController,
        GpioCommandController,
        GripperActionController,
        IMUSensorBroadcaster,
        JointGroupEffortController,
        JointGroupPositionController,
        JointGroupVelocityController,
        JointStateBroadcaster,
        JointTrajectoryController,
        MultiInterfaceForwardCommandController,
        ParallelGripperActionController,
        PassthroughController,
        PidController,
        RangeSensorBroadcaster,
        TricycleSteeringController,
    )
}
