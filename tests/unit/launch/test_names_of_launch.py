"""Tests of names that launch's own tests and packages that extend launch use."""

from __future__ import annotations

import asyncio
import io
import signal
import threading
from typing import TYPE_CHECKING, Any

import pytest

from zbot.compat.launch_utilities import create_future, visit_all_entities_and_collect_futures
from zbot.launch import LaunchContext, LaunchDescription, LaunchService
from zbot.launch.action import Action
from zbot.launch.actions import (
    DeclareBooleanLaunchArgument,
    DeclareLaunchArgument,
    EmitEvent,
    IncludeLaunchDescription,
    Log,
    OpaqueFunction,
    RegisterEventHandler,
    TimerAction,
)
from zbot.launch.condition import IfCondition
from zbot.launch.entity import LaunchDescriptionEntity
from zbot.launch.errors import (
    EntityTypeError,
    InvalidLaunchFileError,
    LaunchFileError,
    LaunchUsageError,
)
from zbot.launch.event import Shutdown
from zbot.launch.event_handler import EventHandler, OnProcessExit, OnShutdown
from zbot.launch.frontend.parser import Parser
from zbot.launch.frontend.registry import expose
from zbot.launch.parameters import evaluate_parameters, normalize_parameters, to_words
from zbot.launch.signal_manager import AsyncSafeSignalManager
from zbot.launch.source import LaunchDescriptionSource

if TYPE_CHECKING:
    from collections.abc import Iterator


@pytest.fixture
def loop() -> Iterator[asyncio.AbstractEventLoop]:
    made = asyncio.new_event_loop()
    yield made
    made.close()


def _run(service: LaunchService, *entities: LaunchDescriptionEntity) -> int:
    service.include_launch_description(LaunchDescription(entities))
    return service.run()


def test_a_service_can_be_run_again() -> None:
    service, reasons = LaunchService(), []
    handler = OnShutdown(on_shutdown=lambda event, _: reasons.append(event.reason))
    assert _run(service, RegisterEventHandler(handler)) == 0
    assert _run(service, OpaqueFunction(function=lambda _: reasons.append("again"))) == 0
    assert reasons == ["idle", "again", "idle"]


def test_a_service_that_failed_succeeds_when_it_runs_again() -> None:
    def fail(_: LaunchContext) -> None:
        raise ValueError("once")

    service = LaunchService()
    assert _run(service, OpaqueFunction(function=fail)) == 1
    assert _run(service) == 0


def test_handlers_receive_every_shutdown() -> None:
    reasons: list[str] = []
    late = TimerAction(
        period=0.05, actions=[EmitEvent(event=Shutdown(reason="late"))], cancel_on_shutdown=False
    )
    code = _run(
        LaunchService(),
        RegisterEventHandler(OnShutdown(on_shutdown=lambda e, _: reasons.append(e.reason))),
        late,
        EmitEvent(event=Shutdown(reason="early")),
    )
    assert (code, reasons) == (0, ["early", "late"])


def test_a_service_does_not_change_the_threads_loop(loop: asyncio.AbstractEventLoop) -> None:
    asyncio.set_event_loop(loop)
    try:
        assert _run(LaunchService()) == 0
        assert asyncio.get_event_loop() is loop
    finally:
        asyncio.set_event_loop(None)


def test_a_service_is_identified_by_the_name_of_its_log(
    capsys: pytest.CaptureFixture[str], tmp_path: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path))
    monkeypatch.setattr("zbot.launch.log.launch_config.log_file_name", "launch.log")
    service = LaunchService(log_file_name="arm")
    assert service.event_loop is None
    seen: list[Any] = []
    assert _run(service, OpaqueFunction(function=lambda _: seen.append(service.task))) == 0
    assert seen[0].done()
    assert "[INFO] [arm]: All log files can be found below" in capsys.readouterr().out
    assert "[INFO] [arm]" in (tmp_path / "latest" / "arm.log").read_text()


def test_a_context_restores_pushed_state() -> None:
    context: Any = LaunchContext()
    context.extend_locals({"a": 1})
    context._push_locals()
    context.extend_locals({"a": 2})
    with pytest.raises(AttributeError):
        context.locals.a = 3
    context._pop_locals()
    assert context.locals.a == 1
    for pop in (context._pop_locals, context._pop_environment, context._pop_launch_configurations):
        with pytest.raises(LaunchUsageError, match="were pushed that could be popped"):
            pop()


def test_a_handler_is_unregistered_once() -> None:
    context, handler = LaunchContext(), EventHandler(matcher=lambda _: True)
    context.register_event_handler(handler)
    context.unregister_event_handler(handler)
    with pytest.raises(LaunchUsageError, match="this event handler is not registered"):
        context.unregister_event_handler(handler)


def test_futures_of_all_visited_entities_are_collected(loop: asyncio.AbstractEventLoop) -> None:
    class Waiting(LaunchDescriptionEntity):
        def get_asyncio_future(self) -> asyncio.Future[Any]:
            return create_future(loop)

    class Group(Waiting):
        def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
            del context
            return [Action(), inner]

    inner, outer = Waiting(), Group()
    found = visit_all_entities_and_collect_futures(outer, LaunchContext())
    assert [entity for entity, _ in found] == [outer, inner]


def test_signals_are_handled_in_the_loop_while_the_manager_is_entered(
    loop: asyncio.AbstractEventLoop,
) -> None:
    outside: list[int] = []
    inside: list[tuple[int, threading.Thread]] = []
    before = signal.signal(signal.SIGINT, lambda number, _: outside.append(number))
    try:
        manager = AsyncSafeSignalManager(loop)
        assert manager.handle(signal.SIGINT, print) is None
        previous_handler = manager.handle(
            signal.SIGINT, lambda number: inside.append((number, threading.current_thread()))
        )
        assert previous_handler is print
        with manager:
            signal.raise_signal(signal.SIGINT)
            assert not inside
            loop.run_until_complete(asyncio.sleep(0))
        signal.raise_signal(signal.SIGINT)
        loop.run_until_complete(asyncio.sleep(0))
    finally:
        signal.signal(signal.SIGINT, before)
    assert inside == [(signal.SIGINT, threading.main_thread())]
    assert outside == [signal.SIGINT, signal.SIGINT]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("$(is-empty '')", "true"),
        ("$(is-empty ' ')", "false"),
        ("$(not-empty x)", "true"),
        ("$(string-strip '  a b ')", "a b"),
    ],
)
def test_substitutions_for_blank_texts_are_evaluated(text: str, expected: str) -> None:
    [made] = Parser().parse_substitution(text)
    assert made.perform(LaunchContext()) == expected
    with pytest.raises(TypeError, match="expects 1 argument, not 2"):
        type(made).parse(["a", "b"])  # type: ignore[attr-defined]


def test_a_boolean_argument_is_true_or_false() -> None:
    argument = DeclareBooleanLaunchArgument("rviz", default_value=True, description="show it")
    assert argument.describe() == (
        "DeclareBooleanLaunchArgument('rviz', default_value='True', description='show it')"
    )
    with pytest.raises(LaunchUsageError, match="not in provided choices"):
        DeclareBooleanLaunchArgument("rviz", default_value="perhaps")


@pytest.mark.parametrize("tag", ["log_debug", "log_info", "log_warning", "log_error"])
def test_a_log_tag_makes_the_action_of_its_level(tag: str) -> None:
    entity, parser = Parser.load(io.StringIO(f"<launch><{tag} message='x'/></launch>"))
    [made] = parser.parse_description(entity).entities
    assert type(made).__name__.lower() == tag.replace("_", "")


def test_mistakes_raise_in_the_callers_line() -> None:
    with pytest.raises(KeyError, match="Invalid log level 'loud'"):
        Log(msg="x", level="loud")
    with pytest.raises(EntityTypeError):
        OnProcessExit(on_exit=["no action"])  # type: ignore[list-item]
    with pytest.raises(LaunchUsageError, match="test parser for five is not a callable"):
        expose("five", {}, "test")(5)  # type: ignore[type-var]
    with pytest.raises(LaunchUsageError, match="neither a launch description nor the path"):
        LaunchDescriptionSource().get_launch_description(LaunchContext())


def test_a_launch_file_error_is_an_invalid_launch_file_error() -> None:
    error: InvalidLaunchFileError = LaunchFileError("a.launch.py", 3, "wrong")
    assert (error.extension, str(error)) == (".py", "a.launch.py:3: wrong")
    other = InvalidLaunchFileError(".xml", likely_errors=[KeyError("a"), OSError("b")])
    assert "KeyError: 'a'; OSError: b" in str(other)


def test_a_description_knows_its_own_arguments() -> None:
    inner = LaunchDescriptionSource(LaunchDescription([DeclareLaunchArgument("inner")]), "<script>")
    description = LaunchDescription(
        [
            DeclareLaunchArgument("always"),
            DeclareLaunchArgument("maybe", condition=IfCondition("true")),
            IncludeLaunchDescription(inner),
        ]
    )
    found = description.get_launch_arguments()
    assert [(argument.name, argument.conditionally_included) for argument in found] == [
        ("always", False),
        ("maybe", True),
    ]


def test_a_path_that_is_not_a_file_is_its_own_folder() -> None:
    context, description = LaunchContext(), LaunchDescription()
    include = IncludeLaunchDescription(LaunchDescriptionSource(description, "<script>"))
    visited = include.visit(context)
    assert visited is not None
    assert visited[0] is description
    assert context.locals.current_launch_file_directory == "<script>"


def test_bytes_stay_bytes_until_a_node_is_given_them() -> None:
    parameters = normalize_parameters([{"data": b"\x01\xff"}])
    assert evaluate_parameters(LaunchContext(), parameters) == ({"data": b"\x01\xff"},)
    assert to_words(LaunchContext(), parameters) == ["-p", "data:=[1, 255]"]
