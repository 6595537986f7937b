"""Tests of what launch files with their own functions and classes use."""

from __future__ import annotations

from enum import Enum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from zbot.compat.launch_utilities import ensure_argument_type, is_a, is_a_subclass
from zbot.launch import (
    Action,
    LaunchContext,
    LaunchDescription,
    LaunchDescriptionSource,
    LaunchService,
    Substitution,
)
from zbot.launch.actions import (
    DeclareLaunchArgument,
    ExecuteProcess,
    ForEach,
    ForLoop,
    IncludeLaunchDescription,
    LogInfo,
    Node,
    OpaqueFunction,
    RegisterEventHandler,
    ReplaceEnvironmentVariables,
    TimerAction,
)
from zbot.launch.condition import (
    AndCondition,
    IfCondition,
    OrCondition,
    UnlessCondition,
    evaluate_condition_expression,
)
from zbot.launch.errors import ConditionError, LaunchUsageError
from zbot.launch.event_handler import EventHandler, OnProcessExit, OnProcessIO, OnShutdown
from zbot.launch.frontend.registry import expose_action, expose_substitution
from zbot.launch.frontend.substitution_text import parse
from zbot.launch.parameters import Parameter, ParameterFile, evaluate_parameters
from zbot.launch.process_event import ProcessExited, ProcessIO
from zbot.launch.source import load_launch_file
from zbot.launch.substitution import perform
from zbot.launch.substitutions import (
    EqualsSubstitution,
    LaunchConfiguration,
    PathSubstitution,
    PythonExpression,
    ThisLaunchFileDir,
)

if TYPE_CHECKING:
    from collections.abc import Callable

YES, NO = IfCondition("true"), IfCondition("false")


def recorder(calls: list[Any], entities: list[Action] | None = None) -> Callable[..., Any]:
    def function(**values: Any) -> Any:
        calls.append(values)
        return entities

    return function


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", []),
        (" ; ", []),
        ("{}", [{}]),
        ("{name: a};{id: 2, name: b}", [{"name": "a"}, {"id": 2, "name": "b"}]),
        ("{names: [a, b]} ;\n", [{"names": ["a", "b"]}]),
    ],
)
def test_for_each_calls_with_the_values_of_every_dictionary(
    text: str, expected: list[dict[str, Any]]
) -> None:
    calls: list[Any] = []
    actions: list[Action] = [LogInfo(msg="x"), LogInfo(msg="y")]
    found = ForEach(text, function=recorder(calls, actions)).visit(LaunchContext())
    assert calls == expected
    assert list(found or ()) == actions * len(expected)
    assert not ForEach(text, function=recorder([])).visit(LaunchContext())


def test_a_loop_counts_from_zero_to_a_configured_number() -> None:
    context, calls = LaunchContext(), list[Any]()
    context.launch_configurations["robots"] = "3"
    found = ForLoop(LaunchConfiguration("robots"), function=recorder(calls)).visit(context) or ()
    for loop in found:
        loop.visit(context)
    assert calls == [{"i": 0}, {"i": 1}, {"i": 2}]


@pytest.mark.parametrize("text", ["", "two", "1.5"])
def test_a_loop_needs_a_whole_number(text: str) -> None:
    with pytest.raises(LaunchUsageError, match="whole number"):
        ForLoop(text, function=recorder([])).visit(LaunchContext())


@pytest.mark.parametrize("text", ["a", "[1]", "{a: 1, b"])
def test_for_each_needs_dictionaries(text: str) -> None:
    with pytest.raises(LaunchUsageError, match="needs dictionaries"):
        ForEach(text, function=recorder([])).visit(LaunchContext())


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        (AndCondition([YES, YES]), True),
        (AndCondition([YES, NO]), False),
        (OrCondition([NO, UnlessCondition("false")]), True),
        (OrCondition([NO, NO]), False),
        (AndCondition([OrCondition([NO, YES]), YES]), True),
    ],
)
def test_conditions_are_combined(condition: AndCondition, holds: bool) -> None:
    assert condition.evaluate(LaunchContext()) is holds


def test_a_condition_is_true_false_or_an_error() -> None:
    assert evaluate_condition_expression(LaunchContext(), ["tr", "ue"])
    with pytest.raises(ConditionError):
        evaluate_condition_expression(LaunchContext(), "maybe")


def test_an_environment_is_replaced_as_a_whole() -> None:
    context = LaunchContext()
    ReplaceEnvironmentVariables({"A": "b"}).visit(context)
    assert context.environment == {"A": "b"}


class Shout(Substitution):
    def __init__(self, text: str) -> None:
        self.text = text

    def perform(self, context: LaunchContext) -> str:  # noqa: ARG002
        return self.text.upper()


def test_functions_make_substitutions_and_actions_of_their_own(tmp_path: Path) -> None:
    @expose_substitution("shout")
    def shout(arguments: Any) -> Any:
        return Shout, {"text": perform(LaunchContext(), arguments[0])}

    @expose_action("greet")
    def greet(entity: Any, parser: Any) -> Any:
        return LogInfo, {"msg": parser.parse_substitution(entity.get_attr("whom"))}

    assert [part.perform(LaunchContext()) for part in parse("a $(shout b)")] == ["a ", "B"]
    file = tmp_path / "own.launch.xml"
    file.write_text('<launch><greet whom="$(shout you)"/></launch>', encoding="utf-8")
    (action,) = load_launch_file(str(file)).entities
    assert isinstance(action, LogInfo)
    assert callable(shout)
    assert callable(greet)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (r"$(env NOT_SET 'a b')", "a b"),
        (r"$(env NOT_SET a\)b)", "a)b"),
        (r"\$\(dirname\)", "$(dirname)"),
        ("""$(eval "math.ceil(sys.maxsize * 0 + 0.5)" " math,sys ")""", "1"),
        ("""$(eval 'ceil(1.3)')""", "2"),
        ("$(eval 1 + 2)", "3"),
    ],
)
def test_texts_are_read_as_ros_reads_them(text: str, expected: str) -> None:
    assert perform(LaunchContext(), parse(text)) == expected


def test_an_expression_accepts_its_modules_in_one_text() -> None:
    expression = PythonExpression("os.sep + str(math.floor(1.5))", "os, math")
    assert expression.perform(LaunchContext()).endswith("1")


def test_the_parameters_of_a_node_can_be_read() -> None:
    context = LaunchContext()
    context.launch_configurations["rate"] = "5"
    node = Node(
        executable="e",
        parameters=[
            {"a": {"b": 1}, "rate": LaunchConfiguration("rate")},
            Parameter("c", 2.5),
            "one.yaml",
            ParameterFile("two.yaml"),
        ],
    )
    assert evaluate_parameters(context, node.parameters) == (
        {"a.b": 1, "rate": 5},
        {"c": 2.5},
        Path("one.yaml"),
        Path("two.yaml"),
    )


def test_the_exit_handler_of_a_process_can_be_read() -> None:
    action = LogInfo(msg="over")
    assert ExecuteProcess(cmd=["a"], on_exit=[action]).get_sub_entities() == [action]
    assert ExecuteProcess(cmd=["a"], on_exit=lambda *_: None).get_sub_entities() == []


@pytest.mark.parametrize("deferred", [True, False])
def test_an_included_file_has_its_folder_in_a_timer_action(deferred: bool) -> None:
    seen: list[tuple[str, str]] = []

    def look(name: str) -> list[Action]:
        def note(context: LaunchContext) -> None:
            seen.append((name, ThisLaunchFileDir().perform(context)))

        action = OpaqueFunction(function=note)
        return [TimerAction(period=0.0, actions=[action])] if deferred else [action]

    inner = LaunchDescriptionSource(LaunchDescription(look("inner")), "/b/inner.launch.py")
    outer = LaunchDescription([IncludeLaunchDescription(inner), *look("outer")])
    service = LaunchService()
    source = LaunchDescriptionSource(outer, "/a/outer.launch.py")
    service.include_launch_description(LaunchDescription([IncludeLaunchDescription(source)]))
    assert service.run() == 0
    assert sorted(seen) == [("inner", str(Path("/b"))), ("outer", str(Path("/a")))]


def test_arguments_are_checked() -> None:
    ensure_argument_type("a", (str, int), "name")
    with pytest.raises(TypeError, match="Robot: name must be str or int, not float"):
        ensure_argument_type(1.5, [str, int], "name", "Robot")
    assert is_a(1, int)
    assert is_a_subclass(bool, int)
    assert not is_a_subclass("1", int)


@pytest.mark.parametrize("options", [{"choices": []}, {"choices": ["a"], "default_value": "b"}])
def test_the_default_of_an_argument_must_be_one_of_its_choices(options: Any) -> None:
    with pytest.raises(LaunchUsageError):
        DeclareLaunchArgument("name", **options)


@pytest.mark.parametrize(
    ("left", "right", "equal"),
    [(1, "1.0", "true"), (None, "", "true"), (Path("a"), Path("b"), "false")],
)
def test_values_of_python_are_compared(left: Any, right: Any, equal: str) -> None:
    assert EqualsSubstitution(left, right).perform(LaunchContext()) == equal


def test_a_path_is_one_text_to_which_parts_are_added() -> None:
    path = PathSubstitution("some") / "path"
    assert path.perform(LaunchContext()) == str(Path("some", "path"))


def test_a_handler_refuses_a_target_that_is_not_an_action() -> None:
    with pytest.raises(TypeError, match="must be an action or a function"):
        OnProcessExit(target_action="talker", on_exit=[])  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_events_can_be_created_and_handled_by_a_program() -> None:
    context, calls = LaunchContext(), list[Any]()
    of: dict[str, Any] = {"name": "a", "cmd": ["a"], "cwd": None, "env": None, "pid": 1}
    event = ProcessIO(action=ExecuteProcess(cmd="a"), text=b"x", fd=2, **of)
    handler = OnProcessIO(on_stderr=partial(calls.append), handle_once=True)
    context.register_event_handler(handler)
    assert not handler.handle(event, context)
    assert calls == [event]
    assert context.locals.event is event
    assert not context.event_handlers
    assert ProcessExited(action=event.action, returncode=3, **of).returncode == 3


def test_an_error_of_a_matcher_ends_the_launch() -> None:
    reasons: list[str] = []

    def matches(event: Any) -> bool:
        return bool(event.foo)

    service = LaunchService()
    handler = RegisterEventHandler(EventHandler(matcher=matches))
    waiting = TimerAction(period=60.0, actions=[])
    heard = OnShutdown(on_shutdown=lambda event, _: reasons.append(event.reason))
    service.context.register_event_handler(heard)
    service.include_launch_description(LaunchDescription([handler, waiting]))
    assert service.run() == 1
    assert "has no attribute 'foo'" in reasons[0]


class Mode(str, Enum):
    FAST = "fast"


def test_the_text_of_an_enum_is_its_value() -> None:
    context = LaunchContext()
    assert perform(context, ["mode ", Mode.FAST]) == "mode fast"
    (found,) = evaluate_parameters(context, [{"mode": Mode.FAST}])
    assert isinstance(found, dict)
    assert type(found["mode"]) is str
