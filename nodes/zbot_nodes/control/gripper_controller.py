"""Open and close a gripper that has one joint.

Types:      position_controllers/GripperActionController (action control_msgs/GripperCommand),
            parallel_gripper_action_controller/GripperActionController
            (action control_msgs/ParallelGripperCommand)
Serves:     ~/gripper_cmd (action)
Parameters: see docs/robot-nodes.md
"""

from __future__ import annotations

from typing import Any

from zbot import Future
from zbot.action import ActionServer, CancelResponse, GoalResponse
from zbot_nodes.control.controller import Controller, ControllerError, State

from control_msgs.action import GripperCommand, ParallelGripperCommand
from sensor_msgs.msg import JointState


class GripperActionController(Controller):
    """Moves the joint to the position of the last goal. A new goal replaces the old goal."""

    kind = "position_controllers/GripperActionController"
    action: Any = GripperCommand
    effort, speed = 0.0, 0.0  #: defaults of `max_effort` and `max_velocity`

    def configure(self) -> None:
        """Read the parameters, and create the action."""
        self.joint = str(self.setting("joint", ""))
        if not self.joint:
            raise ControllerError(f"the parameter joint of {self.get_name()} is empty")
        self.tolerance = self.number("goal_tolerance", 0.01)
        self.may_stall = bool(self.setting("allow_stalling", False))
        self.stall_speed = self.number("stall_velocity_threshold", 0.001)
        self.stall_s = self.number("stall_timeout", 1.0)
        self.setting("action_monitor_rate", 20.0)  # goals are checked in each period
        self.limits = {"max_effort": self.number("max_effort", self.effort)}
        self.goal_handle: Any = None
        self.done: Future[Any] = Future()
        self.server = ActionServer[Any, Any, Any](
            self,
            self.action,
            "~/gripper_cmd",
            goal_callback=self.judge,
            handle_accepted_callback=self.begin,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )

    def command_interfaces(self) -> list[str]:
        """Return the position."""
        return [f"{self.joint}/position"]

    def state_interfaces(self) -> list[str]:
        """Return position and speed."""
        return [f"{self.joint}/position", f"{self.joint}/velocity"]

    def measured(self) -> tuple[float, float]:
        """Return position and speed."""
        position, speed = (self.hardware.states[name] for name in self.state_interfaces())
        return position, speed

    def activate(self) -> None:
        """Hold the present position."""
        self.commands = {self.command_interfaces()[0]: self.measured()[0]}

    def deactivate(self) -> None:
        """Abort the goal."""
        self.finish("abort", 0.0)

    def judge(self, goal: Any) -> GoalResponse:
        """Accept a goal if the controller is active and the goal has a position."""
        reason = self.refusal(goal)
        if self.state is not State.ACTIVE:
            reason = "Can't accept new goals. Controller is not running."
        if reason:
            self.get_logger().error(reason)
            return GoalResponse.REJECT
        self.get_logger().info("Received & accepted new action goal")
        return GoalResponse.ACCEPT

    def refusal(self, goal: Any) -> str:
        """Return why a goal cannot be reached, or an empty string."""
        del goal
        return ""

    def commands_of(self, goal: Any) -> dict[str, float]:
        """Return the commands for a goal."""
        return {f"{self.joint}/position": goal.command.position}

    def begin(self, handle: Any) -> None:
        """Move to the position of an accepted goal. What comes later replaces this goal."""
        self.finish("abort", 0.0)
        self.commands = self.commands_of(handle.request)
        self.moved_ns = self.get_clock().now().nanoseconds
        done: Future[Any] = Future()
        self.goal_handle, self.done = handle, done
        handle.execute(lambda _: done)

    def update(self, period_s: float) -> None:
        """Write the commands, and check the goal."""
        del period_s
        self.hardware.commands.update(self.commands)
        if self.goal_handle is None:
            return
        position, speed = self.measured()
        missing = next(iter(self.commands.values())) - position
        now_ns = self.get_clock().now().nanoseconds
        if self.goal_handle.is_cancel_requested:
            self.activate()
            self.finish("canceled", missing)
        elif abs(missing) < self.tolerance:
            self.finish("succeed", missing)
        elif abs(speed) > self.stall_speed:
            self.moved_ns = now_ns
        elif now_ns - self.moved_ns > self.stall_s * 1e9:
            self.finish("succeed" if self.may_stall else "abort", missing, is_stalled=True)

    def finish(self, end: str, missing: float, *, is_stalled: bool = False) -> None:
        """End the goal, if there is one, with a method of its handle."""
        handle, self.goal_handle = self.goal_handle, None
        if handle is None:
            return
        getattr(handle, end)()
        is_reached = end == "succeed" and abs(missing) < self.tolerance
        self.done.set_result(self.result(self.measured()[0], is_stalled, is_reached))

    def result(self, position: float, is_stalled: bool, is_reached: bool) -> Any:
        """Return the result of a goal."""
        effort = self.limits["max_effort"]
        return self.action.Result(
            position=position, effort=effort, stalled=is_stalled, reached_goal=is_reached
        )


class ParallelGripperActionController(GripperActionController):
    """The same with the newer action. It also limits speed and effort if they have interfaces."""

    kind = "parallel_gripper_action_controller/GripperActionController"
    action = ParallelGripperCommand
    effort, speed = 10.0, 0.1

    def configure(self) -> None:
        """Read the interfaces for the limits."""
        super().configure()
        self.limits["max_velocity"] = self.number("max_velocity", self.speed)
        self.limiting = {kind: str(self.setting(f"{kind}_interface", "")) for kind in self.limits}
        self.setting("state_interfaces", ["position", "velocity"])

    def command_interfaces(self) -> list[str]:
        """Return the position, and the limits that have interfaces."""
        return [*super().command_interfaces(), *filter(None, self.limiting.values())]

    def refusal(self, goal: Any) -> str:
        """Return why a goal cannot be reached, or an empty string."""
        count = len(goal.command.position)
        return "" if count == 1 else f"A goal needs 1 position, but this goal has {count}."

    def commands_of(self, goal: Any) -> dict[str, float]:
        """Return the commands for a goal."""
        commands = {f"{self.joint}/position": goal.command.position[0]}
        for kind, values in (
            ("max_velocity", goal.command.velocity),
            ("max_effort", goal.command.effort),
        ):
            if self.limiting[kind]:
                commands[self.limiting[kind]] = values[0] if len(values) else self.limits[kind]
        return commands

    def result(self, position: float, is_stalled: bool, is_reached: bool) -> Any:
        """Return the result of a goal."""
        state = JointState(name=[self.joint], position=[position], velocity=[0.0])
        state.effort = [self.limits["max_effort"]]
        return self.action.Result(state=state, stalled=is_stalled, reached_goal=is_reached)
