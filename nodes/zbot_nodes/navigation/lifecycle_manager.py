"""Configure and activate managed nodes, one after the other, and deactivate them together.

Run:        zbot run nav2_lifecycle_manager lifecycle_manager --ros-args -p autostart:=true \
                -p "node_names:=[map_server]"
Serves:     lifecycle_manager/manage_nodes (nav2_msgs/ManageLifecycleNodes),
            lifecycle_manager/is_active (std_srvs/Trigger)
Publishes:  lifecycle_manager/managed_nodes_activated (std_msgs/Bool), kept for late subscribers
Parameters: node_names, autostart (false), service_timeout (5.0 s), bond_timeout (4.0 s; 0: do
            not watch the nodes)
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple

import zbot
from zbot.package.unavailable import LEFT_OUT_VARIABLE
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.threads.deadline import Deadline
from zbot_nodes.startup.program import ParameterError, run_node

from lifecycle_msgs.msg import State, Transition
from lifecycle_msgs.srv import ChangeState, GetState
from nav2_msgs.srv import ManageLifecycleNodes
from rcl_interfaces.msg import ParameterDescriptor
from std_msgs.msg import Bool
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable

#: Nodes of Nav2 that zbot does not have. A list with one of them is managed without it.
_LEFT_OUT = frozenset(
    {"docking_server", "following_server", "route_server", "vector_object_server"}
)
#: End of the names of another one. Nav2's launch files start several of them.
_FILTERS = "costmap_filter_info_server"
_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_POLL_S = 0.1
_WATCH_S = 1.0
_CONFIGURE = (Transition.TRANSITION_CONFIGURE, "Configuring", State.PRIMARY_STATE_INACTIVE)
_ACTIVATE = (Transition.TRANSITION_ACTIVATE, "Activating", State.PRIMARY_STATE_ACTIVE)
_DEACTIVATE = (Transition.TRANSITION_DEACTIVATE, "Deactivating", State.PRIMARY_STATE_INACTIVE)
_CLEANUP = (Transition.TRANSITION_CLEANUP, "Cleaning up", State.PRIMARY_STATE_UNCONFIGURED)
_SHUTDOWN = (
    Transition.TRANSITION_UNCONFIGURED_SHUTDOWN,
    "Shutting down",
    State.PRIMARY_STATE_FINALIZED,
)


class _Command(NamedTuple):
    """Command for all nodes: their transitions in order, and what the manager logs."""

    transitions: tuple[tuple[int, str, int], ...]
    begin: str
    end: str
    failure: str
    is_stopped_by_failures: bool = True


#: The texts are those of Nav2. Nav2 has no text for a failed shutdown.
_COMMANDS = {
    ManageLifecycleNodes.Request.STARTUP: _Command(
        (_CONFIGURE, _ACTIVATE),
        "Starting managed nodes bringup...",
        "Managed nodes are active",
        "Failed to bring up all requested nodes. Aborting bringup.",
    ),
    ManageLifecycleNodes.Request.PAUSE: _Command(
        (_DEACTIVATE,),
        "Pausing managed nodes...",
        "Managed nodes have been paused",
        "Failed to pause nodes: aborting pause",
    ),
    ManageLifecycleNodes.Request.RESUME: _Command(
        (_ACTIVATE,),
        "Resuming managed nodes...",
        "Managed nodes are active",
        "Failed to resume nodes: aborting resume",
    ),
    ManageLifecycleNodes.Request.RESET: _Command(
        (_DEACTIVATE, _CLEANUP),
        "Resetting managed nodes...",
        "Managed nodes have been reset",
        "Failed to reset nodes: aborting reset",
    ),
    ManageLifecycleNodes.Request.CONFIGURE: _Command(
        (_CONFIGURE,),
        "Configuring managed nodes...",
        "Managed nodes are now configured",
        "Failed to configure all requested nodes. Aborting bringup.",
    ),
    ManageLifecycleNodes.Request.CLEANUP: _Command(
        (_CLEANUP,),
        "Cleaning up managed nodes...",
        "Managed nodes have been cleaned up",
        "Failed to cleanup all requested nodes. Aborting cleanup.",
    ),
    ManageLifecycleNodes.Request.SHUTDOWN: _Command(
        (_DEACTIVATE, _CLEANUP, _SHUTDOWN),
        "Shutting down managed nodes...",
        "Managed nodes have been shut down",
        "Failed to shut down all nodes",
        is_stopped_by_failures=False,
    ),
}


class LifecycleManager(zbot.Node):
    """Changes the states of its nodes, one after the other.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__("lifecycle_manager", **options)
        any_type = ParameterDescriptor(dynamic_typing=True)
        names = self.declare_parameter("node_names", [], any_type).value
        is_list = not isinstance(names, (str, int, float))
        self.names = [str(name) for name in names] if is_list else []
        if not self.names:
            raise ParameterError("the parameter node_names must name at least one node")
        is_automatic = bool(self.declare_parameter("autostart", False).value)
        self.timeout_s = float(self.declare_parameter("service_timeout", 5.0).value)
        bond_s = float(self.declare_parameter("bond_timeout", 4.0).value)
        self.declare_parameter("bond_respawn_max_duration", 10.0)
        self.declare_parameter("attempt_respawn_reconnection", True)
        self.declare_parameter("bond_heartbeat_period", 0.25)
        self.is_active = False
        # Callbacks wait for other nodes, so a second callback must be able to run meanwhile.
        self.group = zbot.ReentrantCallbackGroup()
        # Other programs start and answer also while the time of a simulation stands still.
        self.real = zbot.Clock(clock_type=zbot.ClockType.STEADY_TIME)
        prefix = self.get_name()
        self.publisher = self.create_publisher(Bool, f"{prefix}/managed_nodes_activated", _KEPT)
        self.changers, self.states = self.create_clients()
        self.create_service(
            ManageLifecycleNodes, f"{prefix}/manage_nodes", self.manage, callback_group=self.group
        )
        self.create_service(Trigger, f"{prefix}/is_active", self.tell)
        self.set_active(is_active=False)
        if is_automatic:
            self.start_timer: zbot.Timer | None = self.create_timer(
                _POLL_S, self.start, callback_group=self.group, clock=self.real
            )
        if bond_s > 0:
            self.create_timer(_WATCH_S, self.watch, callback_group=self.group, clock=self.real)

    def create_clients(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the clients of the nodes' services, by node."""
        changers: dict[str, Any] = {}
        states: dict[str, Any] = {}
        for name in self.names:
            changers[name] = self.create_client(
                ChangeState, f"{name}/change_state", callback_group=self.group
            )
            states[name] = self.create_client(
                GetState, f"{name}/get_state", callback_group=self.group
            )
        return changers, states

    async def start(self) -> None:
        """Configure and activate all nodes. The timer calls this method only once."""
        timer, self.start_timer = self.start_timer, None
        if timer is None:
            return
        self.destroy_timer(timer)
        await self.run(ManageLifecycleNodes.Request.STARTUP)

    async def manage(
        self, request: ManageLifecycleNodes.Request, response: ManageLifecycleNodes.Response
    ) -> ManageLifecycleNodes.Response:
        """Run the command of a request."""
        response.success = request.command in _COMMANDS and await self.run(request.command)
        return response

    async def run(self, number: int) -> bool:
        """Run a command. Return whether all nodes made its transitions."""
        self.leave_out()
        command = _COMMANDS[number]
        last = command.transitions[-1]
        is_up = last in {_CONFIGURE, _ACTIVATE}
        self.get_logger().info(command.begin)
        succeeded = await self.change_all(command, self.names if is_up else self.names[::-1])
        self.set_active(is_active=last is _ACTIVATE and succeeded)
        if succeeded:
            self.get_logger().info(command.end)
        else:
            self.get_logger().error(command.failure)
        return succeeded

    def leave_out(self) -> None:
        """Remove the nodes that zbot or the launch has left out, unless they are there."""
        missing = [
            name
            for name in self.names
            if self.may_be_missing(name) and not self.changers[name].service_is_ready()
        ]
        if missing:
            self.names = [name for name in self.names if name not in missing]
            text = f"left out, because zbot does not have them: {', '.join(missing)}"
            self.get_logger().warning(text)

    def may_be_missing(self, name: str) -> bool:
        """Return whether zbot does not have a node, or the launch has left it out."""
        left_out = os.environ.get(LEFT_OUT_VARIABLE, "").split()
        full = name if name.startswith("/") else f"{self.get_namespace().rstrip('/')}/{name}"
        return name in _LEFT_OUT or name.endswith(_FILTERS) or full in left_out

    async def change_all(self, command: _Command, names: list[str]) -> bool:
        """Make the transitions of some nodes. Return whether all nodes made them."""
        succeeded = True
        for transition in command.transitions:
            for name in names:
                succeeded = await self.change(name, *transition) and succeeded
                if not succeeded and command.is_stopped_by_failures:
                    return False
        return succeeded

    async def change(self, name: str, number: int, what: str, goal: int) -> bool:
        """Make one transition of a node. Return whether the node then has the wanted state."""
        self.get_logger().info(f"{what} {name}")
        request = ChangeState.Request()
        request.transition.id = number
        answer = await self.ask(name, self.changers[name], request)
        state = None
        if answer is not None and answer.success:
            state = await self.ask(name, self.states[name], GetState.Request())
        if state is None or state.current_state.id != goal:
            self.get_logger().error(f"Failed to change state for node: {name}")
            return False
        return True

    async def ask(self, name: str, client: Any, request: Any) -> Any:
        """Call a service of a node. Return None if the call fails, or has no answer in time."""
        if not await self.wait_for(client.service_is_ready, _POLL_S):
            text = f"{name} was not there in {self.timeout_s:g} s: is it a managed node?"
            self.get_logger().error(text)
            return None
        future = client.call_async(request)
        if not await self.wait_for(future.done, _POLL_S / 10):
            client.remove_pending_request(future)
            return None
        error = future.exception()
        if error is not None:
            self.get_logger().error(str(error))
            return None
        return future.result()

    async def wait_for(self, look: Callable[[], bool], pause_s: float) -> bool:
        """Return whether a function returns true within the time limit of services."""
        deadline = Deadline(self.timeout_s)
        while not (seen := look()) and not deadline.is_over:
            await self.pause(pause_s)
        return seen

    async def pause(self, seconds: float) -> None:
        """Let other callbacks run for some seconds of real time."""
        done: zbot.Future[bool] = zbot.Future()

        def end() -> None:
            if not done.done():
                done.set_result(True)

        timer = self.create_timer(seconds, end, callback_group=self.group, clock=self.real)
        await done
        self.destroy_timer(timer)

    async def watch(self) -> None:
        """If a node has ended, deactivate and clean up the other nodes."""
        gone = [name for name in self.names if not self.states[name].service_is_ready()]
        if not self.is_active or not gone:
            return
        self.set_active(is_active=False)
        self.get_logger().error(
            f"CRITICAL FAILURE: SERVER {gone[0]} IS DOWN. Shutting down related nodes."
        )
        for name in reversed(self.names):
            if name not in gone:
                await self.change(name, *_DEACTIVATE)
                await self.change(name, *_CLEANUP)

    def set_active(self, *, is_active: bool) -> None:
        """Store and publish whether all nodes are active."""
        self.is_active = is_active
        self.publisher.publish(Bool(data=is_active))

    def tell(self, _request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        """Answer whether all nodes are active."""
        response.success = self.is_active
        return response


def main() -> None:
    """Run until Ctrl-C."""
    run_node(LifecycleManager)


if __name__ == "__main__":
    main()
