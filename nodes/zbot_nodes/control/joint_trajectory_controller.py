"""Move joints along a trajectory.

Type:       joint_trajectory_controller/JointTrajectoryController
Subscribes: ~/joint_trajectory (trajectory_msgs/JointTrajectory)
Publishes:  ~/controller_state (control_msgs/JointTrajectoryControllerState)
Serves:     ~/follow_joint_trajectory (action control_msgs/FollowJointTrajectory),
            ~/query_state (control_msgs/QueryTrajectoryState)
Parameters: see docs/robot-nodes.md
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot import Future
from zbot.action import ActionServer, CancelResponse, GoalResponse
from zbot_nodes.control.controller import Controller, ControllerError, State
from zbot_nodes.control.pid import read_pid
from zbot_nodes.control.trajectory import Point, Trajectory, problem, read_points, seconds

from control_msgs.action import FollowJointTrajectory
from control_msgs.msg import JointTrajectoryControllerState
from control_msgs.srv import QueryTrajectoryState
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

if TYPE_CHECKING:
    from zbot.action.server_goal_handle import ServerGoalHandle

    Handle = ServerGoalHandle[
        FollowJointTrajectory.Goal, FollowJointTrajectory.Result, FollowJointTrajectory.Feedback
    ]

_DEPTH = 10
_COMMANDS = frozenset({"position", "velocity", "acceleration", "effort"})
Result = FollowJointTrajectory.Result


@dataclass
class ActiveGoal:
    """Goal that the controller executes."""

    handle: Handle
    done: Future[Any]
    path_tolerances: dict[str, float]
    goal_tolerances: dict[str, float]
    goal_time_s: float
    next_feedback_ns: int = 0


class JointTrajectoryController(Controller):
    """Follows one trajectory at a time. A new trajectory replaces the old trajectory."""

    kind = "joint_trajectory_controller/JointTrajectoryController"

    def configure(self) -> None:
        """Read the parameters."""
        self.names = self.joints("joints")
        self.commanded = self.setting("command_joints", []) or self.names
        self.interfaces = [str(kind) for kind in self.setting("command_interfaces", [])]
        if not self.interfaces or not set(self.interfaces) <= _COMMANDS:
            raise ControllerError(
                f"the parameter command_interfaces of {self.get_name()} must name position, "
                "velocity, acceleration or effort"
            )
        self.measures = [str(kind) for kind in self.setting("state_interfaces", [])]
        if "position" not in self.measures:
            raise ControllerError(
                f"the parameter state_interfaces of {self.get_name()} must name position"
            )
        self.is_smooth = self.setting("interpolation_method", "splines") == "splines"
        rate_hz = self.number("action_monitor_rate", 20.0)
        self.feedback_ns = round(1e9 / rate_hz) if rate_hz > 0 else 0
        self.goal_time_s = self.number("constraints.goal_time", 0.0)
        self.stopped = self.number("constraints.stopped_velocity_tolerance", 0.01)
        self.path = {
            joint: self.number(f"constraints.{joint}.trajectory", 0.0) for joint in self.names
        }
        self.ends = {joint: self.number(f"constraints.{joint}.goal", 0.0) for joint in self.names}
        self.pids = {
            joint: read_pid(self, f"gains.{joint}", "ff_velocity_scale") for joint in self.names
        }
        self.setting("allow_partial_joints_goal", False)
        self.setting("allow_nonzero_velocity_at_trajectory_end", False)
        self.goal: ActiveGoal | None = None
        self.trajectory: Trajectory | None = None
        self.create_ports()

    def create_ports(self) -> None:
        """Create the topics, the service and the action."""
        self.publisher = self.create_publisher(
            JointTrajectoryControllerState, "~/controller_state", _DEPTH
        )
        self.create_subscription(JointTrajectory, "~/joint_trajectory", self.accept, _DEPTH)
        self.create_service(QueryTrajectoryState, "~/query_state", self.query)
        self.server: ActionServer[Any, Any, Any] = ActionServer(
            self,
            FollowJointTrajectory,
            "~/follow_joint_trajectory",
            goal_callback=self.judge,
            handle_accepted_callback=self.begin,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )

    def command_interfaces(self) -> list[str]:
        """Return the command interfaces of all joints."""
        return [f"{joint}/{kind}" for kind in self.interfaces for joint in self.commanded]

    def state_interfaces(self) -> list[str]:
        """Return the state interfaces of all joints."""
        return [f"{joint}/{kind}" for kind in self.measures for joint in self.names]

    # -- the state of the joints ---------------------------------------------------------------

    def now_s(self) -> float:
        """Return the present time."""
        return self.get_clock().now().nanoseconds / 1e9

    def measured(self, kind: str) -> tuple[float, ...]:
        """Return the present states of all joints. A state that is not measured is 0."""
        states = self.hardware.states
        return tuple(states.get(f"{joint}/{kind}", 0.0) for joint in self.names)

    def activate(self) -> None:
        """Hold the present position."""
        self.hold()

    def deactivate(self) -> None:
        """Abort the goal, and stop."""
        self.finish(Result.INVALID_GOAL, "The controller was deactivated.")
        moving = [name for name in self.command_interfaces() if not name.endswith("/position")]
        self.hardware.commands.update(dict.fromkeys(moving, 0.0))

    def hold(self) -> None:
        """Stay at the present position."""
        here = Point(0.0, self.measured("position"))
        self.trajectory, self.started_s = Trajectory(here, [here]), self.now_s()

    def follow(self, message: JointTrajectory) -> None:
        """Begin a trajectory."""
        stamp_s = seconds(message.header.stamp)
        now_s = self.now_s()
        self.started_s = stamp_s or now_s
        has_speeds = any(len(point.velocities) for point in message.points)
        speeds = self.measured("velocity") if has_speeds else None
        has_accelerations = any(len(point.accelerations) for point in message.points)
        still = (0.0,) * len(self.names)
        resting = self.measured("position")
        start = Point(now_s - self.started_s, resting, speeds, still if has_accelerations else None)
        points = [
            point
            for point in read_points(message, self.names, resting)
            if point.time_s > start.time_s or point.time_s == 0
        ]
        self.trajectory = Trajectory(start, points)

    def refusal(self, message: JointTrajectory) -> str:
        """Return the reason why a trajectory cannot be followed, or an empty string."""
        if self.state is not State.ACTIVE:
            return "Can't accept new trajectories. Controller is not running."
        reason = problem(
            message,
            self.names,
            may_be_partial=bool(self.setting("allow_partial_joints_goal", False)),
            may_move=bool(self.setting("allow_nonzero_velocity_at_trajectory_end", False)),
        )
        stamp_s = seconds(message.header.stamp)
        if not reason and stamp_s:
            end_s = stamp_s + seconds(message.points[-1].time_from_start)
            if end_s < self.now_s():
                return "Received trajectory with non-zero start time that ends in the past."
        return reason

    def accept(self, message: JointTrajectory) -> None:
        """Follow the trajectory of the topic."""
        reason = self.refusal(message)
        if reason:
            self.get_logger().error(reason)
            return
        self.finish(Result.INVALID_GOAL, "Another trajectory came in its place.")
        self.follow(message)

    # -- the action ----------------------------------------------------------------------------

    def judge(self, goal: FollowJointTrajectory.Goal) -> GoalResponse:
        """Accept a goal whose trajectory can be followed."""
        reason = self.refusal(goal.trajectory)
        if reason:
            self.get_logger().error(reason)
            return GoalResponse.REJECT
        self.get_logger().info("Accepted new action goal")
        return GoalResponse.ACCEPT

    def begin(self, handle: Handle) -> None:
        """Follow the trajectory of an accepted goal.

        This is not left to an execute callback, which runs later: what comes meanwhile, such as a
        message of the topic, replaces this goal.
        """
        self.finish(Result.INVALID_GOAL, "Another trajectory came in its place.")
        request = handle.request
        done: Future[Any] = Future()
        self.goal = ActiveGoal(
            handle,
            done,
            {**self.path, **_tolerances(request.path_tolerance)},
            {**self.ends, **_tolerances(request.goal_tolerance)},
            seconds(request.goal_time_tolerance) or self.goal_time_s,
        )
        self.follow(request.trajectory)
        handle.execute(lambda _: done)

    def finish(self, code: int, text: str) -> None:
        """End the goal, if there is one."""
        goal, self.goal = self.goal, None
        if goal is None:
            return
        result = Result(error_code=code, error_string=text)
        if goal.handle.is_cancel_requested:
            goal.handle.canceled()
        elif code == Result.SUCCESSFUL:
            goal.handle.succeed()
        else:
            self.get_logger().warn(text)
            goal.handle.abort()
        goal.done.set_result(result)

    # -- the loop ------------------------------------------------------------------------------

    def update(self, period_s: float) -> None:
        """Write commands for the present time, and check the goal."""
        if self.trajectory is None:
            return
        time_s = self.now_s() - self.started_s
        wanted = self.trajectory.sample(time_s, is_smooth=self.is_smooth)
        actual = Point(time_s, self.measured("position"), self.measured("velocity"))
        error = self.difference(wanted, actual)
        output = self.command(wanted, error, period_s)
        self.publish_state(wanted, actual, error, output)
        if self.goal is not None:
            self.judge_goal(self.goal, time_s, wanted, actual, error)

    def difference(self, wanted: Point, actual: Point) -> Point:
        """Return the errors of the positions and of the speeds."""
        pairs = zip(self.names, wanted.positions, actual.positions, strict=True)
        positions = tuple(self.pids[joint].error(a, b) for joint, a, b in pairs)
        speeds = zip(wanted.velocities or (), actual.velocities or (), strict=True)
        return Point(wanted.time_s, positions, tuple(a - b for a, b in speeds))

    def command(self, wanted: Point, error: Point, period_s: float) -> dict[str, list[float]]:
        """Write the commands, and return them by kind."""
        output: dict[str, list[float]] = {kind: [] for kind in self.interfaces}
        speeds, wanted_accelerations = wanted.velocities or (), wanted.accelerations or ()
        speed_errors = error.velocities or ()
        for number, joint in enumerate(self.names):
            correction = self.pids[joint].command(
                error.positions[number],
                period_s,
                rate=speed_errors[number],
                wanted=speeds[number],
            )
            values = {
                "position": wanted.positions[number],
                "velocity": speeds[number] if self.has_position() else correction,
                "acceleration": wanted_accelerations[number],
                "effort": correction,
            }
            for kind in self.interfaces:
                output[kind].append(values[kind])
                if joint in self.commanded:
                    self.hardware.commands[f"{joint}/{kind}"] = values[kind]
        return output

    def has_position(self) -> bool:
        """Return whether positions are commanded. If so, velocity commands need no PID."""
        return "position" in self.interfaces

    def publish_state(
        self, wanted: Point, actual: Point, error: Point, output: dict[str, list[float]]
    ) -> None:
        """Publish the wanted and the measured states of the joints."""
        message = JointTrajectoryControllerState(joint_names=self.names)
        message.header.stamp = self.get_clock().now().to_msg()
        message.reference, message.feedback = _message(wanted), _message(actual)
        message.error = _message(error)
        message.output.positions = output.get("position", [])
        message.output.velocities = output.get("velocity", [])
        message.output.accelerations = output.get("acceleration", [])
        message.output.effort = output.get("effort", [])
        message.speed_scaling_factor = 1.0
        self.publisher.publish(message)

    def judge_goal(
        self, goal: ActiveGoal, time_s: float, wanted: Point, actual: Point, error: Point
    ) -> None:
        """Send feedback, and end the goal when it is reached, missed or cancelled."""
        assert self.trajectory is not None
        now_ns = self.get_clock().now().nanoseconds
        if now_ns >= goal.next_feedback_ns:
            goal.next_feedback_ns = now_ns + self.feedback_ns
            self.send_feedback(goal, wanted, actual, error)
        if goal.handle.is_cancel_requested:
            self.hold()
            self.finish(Result.SUCCESSFUL, "Goal was cancelled.")
        elif time_s < self.trajectory.end_s:
            if (joint := self.beyond(error, goal.path_tolerances)) is not None:
                self.hold()
                text = f"Aborted due to path tolerance violation of joint {joint}"
                self.finish(Result.PATH_TOLERANCE_VIOLATED, text)
        elif (joint := self.beyond(error, goal.goal_tolerances)) is None:
            self.finish(Result.SUCCESSFUL, "Goal successfully reached!")
            self.get_logger().info("Goal reached, success!")
        elif goal.goal_time_s and time_s > self.trajectory.end_s + goal.goal_time_s:
            self.hold()
            text = f"Aborted because joint {joint} exceeded goal_time_tolerance"
            self.finish(Result.GOAL_TOLERANCE_VIOLATED, text)

    def send_feedback(self, goal: ActiveGoal, wanted: Point, actual: Point, error: Point) -> None:
        """Send the wanted and the measured states of the joints."""
        feedback = FollowJointTrajectory.Feedback(joint_names=self.names)
        feedback.header.stamp = self.get_clock().now().to_msg()
        feedback.desired, feedback.actual = _message(wanted), _message(actual)
        feedback.error = _message(error)
        goal.handle.publish_feedback(feedback)

    def beyond(self, error: Point, tolerances: dict[str, float]) -> str | None:
        """Return the first joint whose error exceeds its tolerance. Tolerance 0 means no check."""
        for joint, distance in zip(self.names, error.positions, strict=True):
            limit = tolerances.get(joint, 0.0)
            if limit > 0 and abs(distance) > limit:
                return joint
        return None

    def query(
        self, request: QueryTrajectoryState.Request, response: QueryTrajectoryState.Response
    ) -> QueryTrajectoryState.Response:
        """Return the wanted state at a time."""
        response.name = self.names
        response.success = self.state is State.ACTIVE and self.trajectory is not None
        if response.success and self.trajectory is not None:
            found = self.trajectory.sample(seconds(request.time) - self.started_s)
            response.position = list(found.positions)
            response.velocity = list(found.velocities or ())
            response.acceleration = list(found.accelerations or ())
        return response


def _tolerances(messages: Any) -> dict[str, float]:
    """Return the tolerances of positions, by joint. A negative tolerance becomes 0: no check."""
    return {
        tolerance.name: max(0.0, tolerance.position) for tolerance in messages if tolerance.position
    }


def _message(point: Point) -> JointTrajectoryPoint:
    message = JointTrajectoryPoint(positions=list(point.positions))
    message.velocities = list(point.velocities or ())
    message.accelerations = list(point.accelerations or ())
    time_s = max(0.0, point.time_s)
    message.time_from_start.sec = math.floor(time_s)
    message.time_from_start.nanosec = int((time_s % 1) * 1e9)
    return message
