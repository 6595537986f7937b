"""Programs in the styles of public courses, written for rclpy, run as they are.

Each is started as a process of its own, beside what it talks to; the table says what a person would
see on the screen. This is the list of what is known to run.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program

    Start = Callable[..., Program]

PROGRAMS = Path(__file__).parent / "programs"
ANSWER = "Result of add_two_ints: for 41 + 1 = 42"


class Case(NamedTuple):
    """A program, what it has to print, and what runs beside it."""

    program: str
    lines: tuple[str, ...]
    beside: str = ""  #: another program of the survey, or the words after `zbot run`
    words: tuple[str, ...] = ()
    beside_ends: bool = False  #: by itself; Ctrl-C in the middle would be a mistake of its own


CASES = [
    Case("publisher_old_style", ('Publishing: "Hello World: 2"',)),
    Case("publisher_loop_rate", ('[loop]: Publishing: "3"',)),
    Case("publisher_spin_once_loop", ('Publishing: "Hello World: 3"',)),
    Case("subscriber_new_style", ('I heard: "Hello World: ',), "publisher_old_style"),
    Case("subscriber_lambda", ('I heard: "Hello World: ',), "publisher_loop_rate"),
    Case("service_add", ("Incoming request",), "client_until_complete"),
    Case("client_until_complete", (ANSWER,), "service_add"),
    Case("client_in_callback", (ANSWER,), "service_add"),
    Case("client_future_polling", (ANSWER,), "service_add"),
    Case("client_done_callback_partial", (ANSWER,), "service_add"),
    Case("client_sync_thread", (ANSWER,), "service_add"),
    Case("action_server", ("Executing goal...", "Returning result: array"), "action_client"),
    Case(
        "action_client",
        ("Goal accepted :)", "Received feedback: array", "Goal succeeded! Result: array('i', [0, "),
        "action_server",
    ),
    Case("action_client_cancel", ("Canceling goal", "successfully canceled"), "action_server"),
    Case("action_client_until_complete", ("sequence [0, 1, 1, 2]",), "action_server"),
    Case("parameters", ("Hello world! 2.0 True", "set to world")),
    Case("parameter_client", ("set True", "rate 2.0"), "parameters"),
    Case("lifecycle", ("on_configure() is called.", "is active. Publishing: [Lifecycle Hello")),
    Case("tf_broadcaster", ("broadcasting",)),
    Case("tf_listener", ("turned by",), "tf_broadcaster"),
    Case("qos_sensor", ("matched 1", "closest 1.00 of 5")),
    Case("latched", ("got warehouse",)),
    Case("several_nodes_threads", ("still alive 5",)),
    Case("turtle_go_to_goal", ("Goal reached",), "turtlesim"),
    Case("wait_for_one", ("one message: True Hello World: ",), "publisher_old_style"),
    Case("serialized", (r"raw b'\x00\x01\x00\x00' as bytes",)),
    Case(
        "logging_levels",
        (
            "[DEBUG]",
            "[INFO]",
            "[WARN]",
            "old name",
            "[ERROR]",
            "[FATAL]",
            "only once",
            "not the first 1",
            "[elsewhere]: without a node",
            "[talkative.part]: a child",
        ),
    ),
    Case("asyncio_beside", ("heard in asyncio",)),
    Case("time_and_clock", ("passed True True", "True True", "True")),
    Case("namespaced", ("['/fleet/a', '/fleet/worker/b', '/c'] worker /fleet /fleet/worker",)),
    Case("graph_queries", ("True True [('looker', '/')] 1 looker",)),
    Case("composition", ("I heard: [Hello World: ",)),
    Case("set_bool_trigger", ("[motor]: on", "[motor]: motor is on")),
    Case("image_publisher", ("green 7.0 bgr8",)),
    Case("odometry", ("path of 10 to True",)),
    Case("timer_cancel_reset", ("0 left", "[Quitting]: Done")),
    Case("guard_condition", ("triggered",)),
    Case("await_in_timer", ("slept without blocking",)),
    Case("custom_dataclass_free", ("True 2.5 map float", "refused")),
    Case("publisher_local_function", ("Publishing 3",)),
    Case("subscriber_thread", ("arrived True",), "publisher_local_function"),
    Case("subscriber_message_info", ("fresh: True",), "publisher_local_function"),
    Case("subscriber_raw", ("True 00010000 True Hello",), "publisher_local_function"),
    Case("service_async", ("answered",), "client_await"),
    Case("client_await", ("Result of add_two_ints: 42",), "service_async"),
    Case("action_client_asyncio", ("Result: [0, 1, 1, 2, 3]",), "action_server"),
    Case("parameter_types", ("True [1, 2] ['x', 'y'] 2.5", "INTEGER_ARRAY False")),
    Case("parameter_events", ("gain is 2", "gain is 3")),
    Case("lifecycle_node", ("on_activate() is called.",), "lifecycle_client", beside_ends=True),
    Case("lifecycle_client", ("changed True", "changed True", "state active"), "lifecycle_node"),
    Case("qos_deadline", ("Requested deadline missed: True",)),
    Case("qos_latched_publisher", ("published once",)),
    Case("qos_latched_subscriber", ("but heard: the map",), "qos_latched_publisher"),
    Case("two_nodes_one_executor", ("I heard: [Hello World: 3]",)),
    Case("callback_groups", ("was not alone",)),
    Case("rate_loop", ("counted to 5",)),
    Case("numpy_laser", ("nearest 1.0 at 0, mean 2.5",)),
    Case("names", ("/zoo/turtle/status /zoo/food /ns/a", "True 1", "names are done")),
    Case("shutdown_inside", ("[Quitting]: Done",)),
    Case("own_context", ("ticked True False False",)),
    Case(
        "remapped",
        ("/ns/new /ns/other hi ['one', 'two']",),
        words=(
            "one",
            "--ros-args",
            *("-r", "__node:=new", "-r", "__ns:=/ns", "-r", "topic:=other", "-p", "greeting:=hi"),
            *("--", "two"),
        ),
    ),
    Case(
        "launch_arguments",
        ("5 2.5 renamed",),
        words=("--count", "5", "--ros-args", "-p", "speed:=2.5", "-r", "__node:=renamed"),
    ),
]


def test_every_program_of_the_survey_is_in_the_table() -> None:
    assert sorted(path.stem for path in PROGRAMS.glob("*.py")) == sorted(
        case.program for case in CASES
    )


@pytest.mark.parametrize("case", CASES, ids=[case.program for case in CASES])
def test_it_runs_as_it_is(case: Case, start: Start) -> None:
    def run(name: str, *words: str) -> Program:
        path = PROGRAMS / f"{name}.py"
        return start("zbot", "run", str(path) if path.is_file() else name, *words)

    beside = run(case.beside) if case.beside else None
    program = run(case.program, *case.words)
    for line in case.lines:
        program.wait_for(line, 20)
    if beside and case.beside_ends:
        beside.wait(20)
    for one in (beside, program):
        if one is not None:
            one.stop()
            assert "Traceback" not in one.output
