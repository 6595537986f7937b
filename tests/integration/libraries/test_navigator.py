"""Tests of `BasicNavigator` with a node that has the actions and services of Nav2."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.action import ActionServer, CancelResponse, GoalResponse
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.libraries.navigation.navigator import BasicNavigator, RunningTask, TaskResult
from zbot.qos import DurabilityPolicy, QoSProfile

from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from lifecycle_msgs.srv import GetState
from nav2_msgs import action, srv
from nav_msgs.msg import Goals, Path

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.conftest import MakeContext, Spin

REFUSED_X = -1.0
FAILING_X = -2.0
ENDLESS_X = -3.0


class Nav2(zbot.Node):
    """Answers like Nav2. A place with a negative x is refused, fails, or is never reached."""

    def __init__(self, context: zbot.Context) -> None:
        super().__init__("nav2", namespace="/robot", context=context)
        self.goals: list[Any] = []
        self.requests: list[Any] = []
        self.pose_publisher = self.create_publisher(
            PoseWithCovarianceStamped,
            "amcl_pose",
            QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL),
        )
        self.create_subscription(
            PoseWithCovarianceStamped, "initialpose", self.pose_publisher.publish, 1
        )
        for kind, name in (
            (action.NavigateToPose, "navigate_to_pose"),
            (action.NavigateThroughPoses, "navigate_through_poses"),
            (action.ComputePathToPose, "compute_path_to_pose"),
            (action.ComputeAndTrackRoute, "compute_and_track_route"),
            (action.Spin, "spin"),
            (action.DockRobot, "dock_robot"),
            (action.UndockRobot, "undock_robot"),
        ):
            ActionServer[Any, Any, Any](
                self,
                kind,
                name,
                self.execute,
                goal_callback=self.judge,
                cancel_callback=lambda _: CancelResponse.ACCEPT,
                callback_group=ReentrantCallbackGroup(),
            )
        services: tuple[tuple[Any, str], ...] = (
            (GetState, "amcl/get_state"),
            (GetState, "bt_navigator/get_state"),
            (srv.LoadMap, "map_server/load_map"),
            (srv.ManageLifecycleNodes, "lifecycle_manager/manage_nodes"),
            (srv.ClearEntireCostmap, "local_costmap/clear_entirely_local_costmap"),
            (srv.ClearEntireCostmap, "global_costmap/clear_entirely_global_costmap"),
            (srv.GetCostmap, "global_costmap/get_costmap"),
        )
        for service, name in services:
            self.create_service(service, name, self.answer)

    def judge(self, goal: Any) -> GoalResponse:
        is_refused = isinstance(goal, action.NavigateToPose.Goal) and (
            goal.pose.pose.position.x == REFUSED_X
        )
        return GoalResponse.REJECT if is_refused else GoalResponse.ACCEPT

    async def execute(self, handle: Any) -> Any:
        goal = handle.request
        self.goals.append(goal)
        kind: Any = next(
            member
            for member in vars(action).values()
            if getattr(member, "Goal", None) is type(goal)
        )
        feedback = kind.Feedback()
        if isinstance(goal, action.NavigateToPose.Goal):
            feedback.distance_remaining = 3.0
            handle.publish_feedback(feedback)
            while goal.pose.pose.position.x == ENDLESS_X and not handle.is_cancel_requested:
                await self.nap()
            if handle.is_cancel_requested:
                handle.canceled()
                return kind.Result()
            if goal.pose.pose.position.x == FAILING_X:
                handle.abort()
                return kind.Result(error_code=9003, error_msg="lost")
        for number in range(3 if isinstance(goal, action.ComputeAndTrackRoute.Goal) else 0):
            feedback.current_edge_id = number
            handle.publish_feedback(feedback)
        handle.succeed()
        result = kind.Result()
        if isinstance(goal, action.ComputePathToPose.Goal):
            result.path = Path(poses=[goal.start, goal.goal])
        return result

    async def nap(self) -> None:
        future: zbot.Future[None] = zbot.Future()
        timer = self.create_timer(0.02, lambda: future.set_result(None))
        await future
        self.destroy_timer(timer)

    def answer(self, request: Any, response: Any) -> Any:
        self.requests.append(request)
        if isinstance(response, GetState.Response):
            response.current_state.label = "active"
        if isinstance(response, srv.LoadMap.Response) and not request.map_url:
            response.result = srv.LoadMap.Response.RESULT_MAP_DOES_NOT_EXIST
        if isinstance(response, srv.GetCostmap.Response):
            response.map.metadata.size_x = 4
        return response


@pytest.fixture
def nav2(make_context: MakeContext, spin: Spin) -> Nav2:
    made = Nav2(make_context())
    spin(made)
    return made


@pytest.fixture
def navigator(nav2: Nav2) -> Iterator[BasicNavigator]:
    with zbot.init():
        yield BasicNavigator(namespace=nav2.get_namespace())


def place(x: float) -> PoseStamped:
    pose = PoseStamped()
    pose.header.frame_id = "map"
    pose.pose.position.x = x
    return pose


def finish(navigator: BasicNavigator, task: RunningTask | None) -> TaskResult:
    assert task is not None
    while not navigator.isTaskComplete(task=task):
        pass
    return navigator.getResult()


def test_a_robot_is_sent_to_a_place(nav2: Nav2, navigator: BasicNavigator) -> None:
    navigator.setInitialPose(place(0.5))
    navigator.waitUntilNav2Active()
    assert navigator.initial_pose_received
    task = navigator.goToPose(place(2.0), behavior_tree="tree.xml")
    assert (task, finish(navigator, task)) == (RunningTask.NAVIGATE_TO_POSE, TaskResult.SUCCEEDED)
    assert nav2.goals[0].behavior_tree == "tree.xml"
    assert navigator.getFeedback().distance_remaining == 3.0
    assert navigator.getTaskError() == (0, "")


def test_a_refused_goal_is_no_task(navigator: BasicNavigator) -> None:
    assert navigator.goToPose(place(REFUSED_X)) is None
    code = action.NavigateToPose.Result.UNKNOWN
    assert navigator.getTaskError() == (code, "NavigateToPose request was rejected!")


def test_a_failed_task_has_the_error_of_the_server(navigator: BasicNavigator) -> None:
    assert finish(navigator, navigator.goToPose(place(FAILING_X))) is TaskResult.FAILED
    assert navigator.getTaskError() == (9003, "lost")


def test_a_task_is_cancelled(navigator: BasicNavigator) -> None:
    task = navigator.goToPose(place(ENDLESS_X))
    assert not navigator.isTaskComplete()
    navigator.cancelTask()
    assert finish(navigator, task) is TaskResult.CANCELED


def test_a_task_ends_when_its_server_ends(nav2: Nav2, navigator: BasicNavigator) -> None:
    task = navigator.goToPose(place(ENDLESS_X))
    nav2.context.shutdown()
    assert finish(navigator, task) is TaskResult.UNKNOWN
    assert "navigate_to_pose" in navigator.getTaskError()[1]


@pytest.mark.parametrize("form", [list, lambda poses: Goals(goals=poses)])
def test_places_are_a_list_or_a_message(
    nav2: Nav2, navigator: BasicNavigator, form: Callable[[Any], Any]
) -> None:
    task = navigator.goThroughPoses(form([place(1.0), place(2.0)]))
    assert finish(navigator, task) is TaskResult.SUCCEEDED
    assert [goal.pose.position.x for goal in nav2.goals[0].poses.goals] == [1.0, 2.0]


def test_numbers_may_be_whole(nav2: Nav2, navigator: BasicNavigator) -> None:
    assert finish(navigator, navigator.spin(3, time_allowance=4)) is TaskResult.SUCCEEDED
    goal = nav2.goals[0]
    assert (goal.target_yaw, goal.time_allowance.sec) == (3.0, 4)


def test_a_robot_docks_at_a_place_or_a_name(nav2: Nav2, navigator: BasicNavigator) -> None:
    dock = place(1.5)
    by_pose = navigator.dockRobotByPose(dock, "charger", nav_to_dock=False)
    assert (by_pose, finish(navigator, by_pose)) == (RunningTask.DOCK_ROBOT, TaskResult.SUCCEEDED)
    finish(navigator, navigator.dockRobotByID("home"))
    leaving = navigator.undockRobot("charger")
    assert (leaving, finish(navigator, leaving)) == (RunningTask.UNDOCK_ROBOT, TaskResult.SUCCEEDED)
    assert nav2.goals == [
        action.DockRobot.Goal(
            dock_pose=dock, dock_type="charger", use_dock_id=False, navigate_to_staging_pose=False
        ),
        action.DockRobot.Goal(dock_id="home", use_dock_id=True, navigate_to_staging_pose=True),
        action.UndockRobot.Goal(dock_type="charger"),
    ]


def test_a_path_is_returned(navigator: BasicNavigator) -> None:
    path = navigator.getPath(place(1.0), place(2.0), use_start=True)
    assert path is not None
    assert [pose.pose.position.x for pose in path.poses] == [1.0, 2.0]


def test_feedback_of_a_route_is_complete_beside_another_task(navigator: BasicNavigator) -> None:
    route = navigator.getAndTrackRoute(0, 5)
    assert finish(navigator, navigator.goToPose(place(1.0))) is TaskResult.SUCCEEDED
    assert finish(navigator, route) is TaskResult.SUCCEEDED
    edges = [navigator.getFeedback(RunningTask.COMPUTE_AND_TRACK_ROUTE) for _ in range(4)]
    assert [edge and edge.current_edge_id for edge in edges] == [0, 1, 2, None]


def test_a_route_needs_two_ids_or_two_poses(navigator: BasicNavigator) -> None:
    wrong: Any = place(1.0)
    assert navigator.getRoute(3, wrong) is None
    assert navigator.getTaskError()[1] == "Request type fields were invalid!"


def test_services_of_nav2_are_called(nav2: Nav2, navigator: BasicNavigator) -> None:
    assert navigator.changeMap("lab.yaml")
    assert not navigator.changeMap("")
    assert navigator.getTaskError()[1] == "Map does not exist"
    navigator.clearAllCostmaps()
    costmap = navigator.getGlobalCostmap()
    assert costmap is not None
    assert costmap.metadata.size_x == 4
    navigator.lifecycleStartup()
    navigator.lifecycleShutdown()
    commands = [
        request.command
        for request in nav2.requests
        if isinstance(request, srv.ManageLifecycleNodes.Request)
    ]
    assert commands == [0, 4]
