"""Functions that the fixtures return. They make nodes, spin them, wait for messages and call."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn, TypeVar, overload

from zbot.interfaces.python_class import type_name
from zbot.node.node import Node
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.testing import report
from zbot.testing.program import Program
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from pathlib import Path

    from zbot.executor.executor import Executor

N = TypeVar("N", bound=Node)

# A condition may become true without a callback, e.g. by the output of a program.
_LOOK_S = 0.02
_QUEUE = 100  # messages that wait while the test runs other callbacks


class NodeFactory:
    """Function that makes nodes, and adds them to the executor of the test.

    Args:
        executor: The executor of the test.
    """

    def __init__(self, executor: Executor) -> None:
        self._executor = executor
        self._nodes: list[Node] = []

    @overload
    def __call__(self, make: str = "tester", **options: Any) -> Node: ...

    @overload
    def __call__(self, make: Callable[..., N] | N, *args: Any, **options: Any) -> N: ...

    def __call__(
        self, make: str | Callable[..., Node] | Node = "tester", *args: Any, **options: Any
    ) -> Node:
        """Make a node, which spins while the test waits, and is destroyed after the test.

        Args:
            make: A class of nodes, or the name of a new plain node, or a node that exists.
            args: The arguments of the class.
            options: The keyword arguments of the class, or those of `Node`.
        """
        if isinstance(make, str):
            node = Node(make, *args, **options)
        else:
            node = make if isinstance(make, Node) else make(*args, **options)
        self._nodes.append(node)
        self._executor.add_node(node)
        return node

    def destroy(self) -> None:
        """Destroy the nodes. The last node is the first."""
        for node in reversed(self._nodes):
            node.destroy_node()


class SpinUntil:
    """Function that spins the nodes of the test until a condition is true.

    Args:
        executor: The executor with the nodes.
        programs: The programs that the test has started. The report of a failure shows their state.
    """

    def __init__(self, executor: Executor, programs: Sequence[Program]) -> None:
        self._executor, self._programs = executor, programs

    def __call__(self, condition: Callable[[], object], timeout: float = 10.0) -> None:
        """Spin until `condition()` is true, and fail the test if this takes too long.

        An exception of a callback is raised here.

        Args:
            condition: Called again and again, between callbacks.
            timeout: The longest time to spin, in seconds.
        """
        __tracebackhide__ = True
        if not self.comes(condition, timeout):
            self.fail(f"the condition was not true within {timeout:g} s", report.values(condition))

    def comes(self, condition: Callable[[], object], timeout: float) -> bool:
        """Spin until `condition()` is true, at most `timeout` seconds. Return whether it is."""
        deadline = Deadline(timeout)
        while not condition():
            if deadline.is_over:
                return False
            self._executor.spin_once(timeout_sec=min(deadline.left_s, _LOOK_S))
        return True

    def fail(self, *lines: str) -> NoReturn:
        """Fail the test. The text has the lines, and what there was instead.

        Raises:
            AssertionError: Always.
        """
        __tracebackhide__ = True
        seen = report.domain(self._executor.context), report.states(self._programs)
        raise AssertionError("\n".join(filter(None, (*lines, *seen))))


class Received:
    """Function that waits for messages of a topic.

    Args:
        spin_until: The function that spins.
        node: The function that makes nodes.
    """

    def __init__(self, spin_until: SpinUntil, node: NodeFactory) -> None:
        self._spin_until, self._make = spin_until, node

    def __call__(
        self,
        topic: str,
        msg_type: type[Any],
        n: int = 1,
        *,
        timeout: float = 10.0,
        qos_profile: QoSProfile | int | None = None,
    ) -> list[Any]:
        """Subscribe to a topic, spin until `n` messages have come, and return them.

        It fails the test if they do not come in time. It gets the messages that are published after
        the call, and before that the messages that a publisher keeps (`TRANSIENT_LOCAL`).

        Args:
            topic: The name of the topic.
            msg_type: The type of its messages, e.g. `std_msgs.msg.String`.
            n: The number of messages.
            timeout: The longest time to spin, in seconds.
            qos_profile: The profile of the subscription. `None` fits all publishers.
        """
        __tracebackhide__ = True
        if qos_profile is None:
            qos_profile = QoSProfile(
                depth=max(n, _QUEUE), durability=DurabilityPolicy.TRANSIENT_LOCAL
            )
        node, messages = _helper(self._make), list[Any]()
        subscription = node.create_subscription(msg_type, topic, messages.append, qos_profile)
        if not self._spin_until.comes(lambda: len(messages) >= n, timeout):
            self._spin_until.fail(
                f"{len(messages)} of {n} messages came on {subscription.topic_name} within "
                f"{timeout:g} s",
                *map(report.shortened, messages),
                report.publishers(node.context, subscription.topic_name, type_name(msg_type)),
            )
        node.destroy_subscription(subscription)
        return messages[:n]


class Call:
    """Function that calls a service.

    Args:
        spin_until: The function that spins.
        node: The function that makes nodes.
    """

    def __init__(self, spin_until: SpinUntil, node: NodeFactory) -> None:
        self._spin_until, self._make = spin_until, node

    def __call__(
        self, service: str, srv_type: type[Any], request: Any = None, *, timeout: float = 10.0
    ) -> Any:
        """Wait for a server, call it, spin until the response has come, and return the response.

        Args:
            service: The name of the service.
            srv_type: The type of the service, e.g. `std_srvs.srv.SetBool`.
            request: The request. `None` means an empty one.
            timeout: The longest time to wait for the server, and for its response, in seconds.
        """
        __tracebackhide__ = True
        node = _helper(self._make)
        client = node.create_client(srv_type, service)
        is_there = self._spin_until.comes(client.service_is_ready, timeout)
        problem = report.servers(node.context, client.service_name, type_name(srv_type))
        if not is_there:
            missing = f"no server of {client.service_name} came within {timeout:g} s"
            self._spin_until.fail(missing, problem)
        if problem:
            self._spin_until.fail(f"{client.service_name} cannot be called: {problem}")
        future = client.call_async(srv_type.Request() if request is None else request)
        if not self._spin_until.comes(future.done, timeout):
            self._spin_until.fail(
                f"{client.service_name} did not answer within {timeout:g} s",
                f"the request was {report.shortened(request)}",
            )
        node.destroy_client(client)
        return future.result()


def _helper(make: NodeFactory) -> Node:
    """Return a hidden node, which the report of a failure does not show."""
    return make("_tester", enable_rosout=False, start_parameter_services=False)


class Start:
    """Function that starts programs.

    Args:
        programs: The programs of the test. A call adds its program.
    """

    def __init__(self, programs: list[Program]) -> None:
        self._programs = programs

    def __call__(
        self,
        *command: str,
        cwd: str | Path | None = None,
        env: Mapping[str, str] | None = None,
    ) -> Program:
        """Start a program, e.g. `start("zbot", "run", "sensor")`.

        The program is ended after the test, as by Ctrl-C. If the test fails, its report has the
        program's output.

        Args:
            command: The words of the command. `zbot`, `ros2`, `python` and `python3` are those of
                the Python that runs the test.
            cwd: The folder in which the program runs. `None` means the current folder.
            env: Its environment. `None` means that of the test.
        """
        program = Program(command, cwd, env)
        self._programs.append(program)
        return program
