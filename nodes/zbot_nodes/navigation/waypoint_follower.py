"""Send a robot to one place after the other, and wait at each.

Run:        zbot run nav2_waypoint_follower waypoint_follower, then configure and activate it
Action:     follow_waypoints (nav2_msgs/FollowWaypoints)
Uses:       navigate_to_pose (nav2_msgs/NavigateToPose)
"""

from __future__ import annotations

from typing import Any

from zbot_nodes.navigation.managed_server import ManagedServer, Ticker, end_goal
from zbot_nodes.navigation.remote_actions import RemoteActions, RemoteError, cancel
from zbot_nodes.startup.program import run_node

from nav2_msgs.action import FollowWaypoints, NavigateToPose
from nav2_msgs.msg import WaypointStatus

_ERRORS = FollowWaypoints.Result
_PERIOD_S = 0.1


class WaypointFollower(ManagedServer):
    """Follows one list of waypoints at a time.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("waypoint_follower", **options)

    def configure(self) -> None:
        """Create the client and the action."""
        settings = self.settings
        self.stops_on_failure = settings.flag("stop_on_failure", default=True)
        task = settings.text("waypoint_task_executor_plugin", "wait_at_waypoint")
        settings.text(f"{task}.plugin", "nav2_waypoint_follower::WaitAtWaypoint")
        is_waiting = settings.flag(f"{task}.enabled", default=True)
        pause_ms = settings.number(f"{task}.waypoint_pause_duration", 0.0)
        self.pause_s = pause_ms / 1000 if is_waiting else 0.0
        self.remote = RemoteActions(self, {"navigate_to_pose": NavigateToPose})
        self.create_action(FollowWaypoints, "follow_waypoints", self.follow)

    def clean_up(self) -> None:
        """Destroy the client."""
        self.remote.close()

    async def follow(self, handle: Any) -> Any:
        """Visit the waypoints of a goal."""
        goal, result = handle.request, FollowWaypoints.Result()
        if not goal.poses:
            text = "no waypoints are given"
            return end_goal(handle, result, _ERRORS.NO_VALID_WAYPOINTS, text)
        rounds = max(goal.number_of_loops, 0) + 1
        numbers = [number for _ in range(rounds) for number in range(len(goal.poses))]
        ticker, code, text = Ticker(self, _PERIOD_S), 0, ""
        try:
            for number in numbers[goal.goal_index :]:
                feedback = FollowWaypoints.Feedback(current_waypoint=number)
                handle.publish_feedback(feedback)
                await self.visit(handle, number, result, ticker)
                if not self.is_wanted("follow_waypoints", handle):
                    break
        except RemoteError as error:
            code, text = _ERRORS.STOP_ON_MISSED_WAYPOINT, str(error)
        finally:
            ticker.close()
        if not code and not self.is_newest("follow_waypoints", handle):
            code, text = _ERRORS.UNKNOWN, "newer waypoints came"
        return end_goal(handle, result, code, text)

    async def visit(self, handle: Any, number: int, result: Any, ticker: Ticker) -> None:
        """Go to a waypoint, and wait there.

        Raises:
            RemoteError: The robot missed it, and the parameters say that this is the end.
        """
        pose, running = handle.request.poses[number], None
        try:
            running = await self.remote.start("navigate_to_pose", NavigateToPose.Goal(pose=pose))
            while not running.is_over:
                if not self.is_wanted("follow_waypoints", handle):
                    return
                await ticker.next()
            running.result()
        except RemoteError as error:
            self.get_logger().warning(f"Failed to process waypoint {number}: {error}")
            status = WaypointStatus(waypoint_index=number, waypoint_pose=pose)
            status.waypoint_status, status.error_code = WaypointStatus.FAILED, error.code
            status.error_msg = str(error)
            result.missed_waypoints.append(status)
            if self.stops_on_failure:
                raise
            return
        finally:
            await cancel(running)
        self.get_logger().info(f"Arrived at waypoint {number}")
        end_s = self.seconds() + self.pause_s
        while self.seconds() < end_s and self.is_wanted("follow_waypoints", handle):
            await ticker.next()


def main() -> None:
    """Run until Ctrl-C."""
    run_node(WaypointFollower)


if __name__ == "__main__":
    main()
