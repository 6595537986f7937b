"""Tests of launches in this process: the service, events, managed nodes, ROS 2's names."""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import zbot.compat
from zbot.errors import ExternalShutdownException
from zbot.launch import LaunchDescription, LaunchService
from zbot.launch.actions import (
    DeclareLaunchArgument,
    EmitEvent,
    ExecuteProcess,
    GroupAction,
    LifecycleNode,
    LogInfo,
    OpaqueCoroutine,
    OpaqueFunction,
    RegisterEventHandler,
    RosTimer,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
    UnregisterEventHandler,
)
from zbot.launch.actions.lifecycle_node import ChangeState, OnStateTransition
from zbot.launch.event import Event
from zbot.launch.event import Shutdown as ShutdownEvent
from zbot.launch.event_handler import (
    EventHandler,
    OnExecutionComplete,
    OnProcessExit,
    OnProcessIO,
    OnProcessStart,
    OnShutdown,
)
from zbot.launch.process_event import ProcessStdin, ShutdownProcess, matches_action, matches_name
from zbot.launch.ros_node import LaunchNode
from zbot.launch.substitutions import (
    EnvironmentVariable,
    LaunchConfiguration,
    TextSubstitution,
)

if TYPE_CHECKING:
    from zbot.launch import LaunchContext

_CONFIGURE, _ACTIVATE = 1, 3


@pytest.fixture(autouse=True)
def folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


def _python(code: str, **options: Any) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", code], **options)


def _run(*entities: Any) -> int:
    service = LaunchService(noninteractive=True)
    service.include_launch_description(LaunchDescription(entities))
    return service.run()


def _logged_messages(capsys: pytest.CaptureFixture[str]) -> list[str]:
    out = capsys.readouterr().out.splitlines()
    start = "[INFO] [launch.user]: "
    return [line.removeprefix(start) for line in out if line.startswith(start)]


def test_a_group_keeps_its_configurations_to_itself(capsys: pytest.CaptureFixture[str]) -> None:
    def tell() -> LogInfo:
        return LogInfo(
            msg=[LaunchConfiguration("x"), " ", EnvironmentVariable("COLOUR", default_value="-")]
        )

    sets = [SetLaunchConfiguration("x", "2"), SetEnvironmentVariable("COLOUR", "red"), tell()]
    first = SetLaunchConfiguration("x", "1")
    assert _run(first, GroupAction(sets), tell(), GroupAction(sets, scoped=False), tell()) == 0
    assert _logged_messages(capsys) == ["2 red", "1 -", "2 red", "2 red"]


def test_code_and_programs_share_the_environment_during_the_launch(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SHAPE", "")  # restored afterwards

    def function(_: LaunchContext) -> None:
        os.environ["SHAPE"] = f"{os.environ['COLOUR']} ball"

    code = _run(
        SetEnvironmentVariable("COLOUR", "red"),
        OpaqueFunction(function=function),
        _python("import os; print('a', os.environ['SHAPE'])", name="shape"),
    )
    assert code == 0
    assert "[shape-1] a red ball" in capsys.readouterr().out
    assert "COLOUR" not in os.environ


def test_a_group_may_have_only_given_configurations(capsys: pytest.CaptureFixture[str]) -> None:
    inner = LogInfo(msg=[LaunchConfiguration("x", default="none"), LaunchConfiguration("y")])
    group = GroupAction([inner], forwarding=False, launch_configurations={"y": "2"})
    assert _run(SetLaunchConfiguration("x", "1"), group) == 0
    assert _logged_messages(capsys) == ["none2"]


def test_functions_and_coroutines_are_actions(capsys: pytest.CaptureFixture[str]) -> None:
    def function(context: LaunchContext, word: str, *, times: int) -> list[LogInfo]:
        return [LogInfo(msg=word * times + LaunchConfiguration("x").perform(context))]

    async def coroutine(context: LaunchContext) -> None:
        await context.emit_event(ShutdownEvent(reason="coroutine"))

    code = _run(
        DeclareLaunchArgument("x", default_value="!"),
        OpaqueFunction(function=function, args=["ab"], kwargs={"times": 2}),
        OpaqueCoroutine(coroutine=coroutine),
        TimerAction(period=60.0, actions=[LogInfo(msg="never")]),
    )
    assert code == 0
    assert _logged_messages(capsys) == ["abab!"]


def test_a_coroutine_that_raises_ends_the_launch(capsys: pytest.CaptureFixture[str]) -> None:
    async def coroutine() -> None:
        raise ValueError("oh")

    assert _run(OpaqueCoroutine(coroutine=coroutine, ignore_context=True)) == 1
    assert "[ERROR] [launch]: ValueError: oh" in capsys.readouterr().out


def test_handlers_get_events_until_unregistered(capsys: pytest.CaptureFixture[str]) -> None:
    class Ping(Event):
        pass

    handler = EventHandler(matcher=lambda e: isinstance(e, Ping), entities=[LogInfo(msg="ping")])
    emit = EmitEvent(event=Ping())
    after = EmitEvent(event=Ping())
    code = _run(
        RegisterEventHandler(handler),
        emit,
        TimerAction(period=0.01, actions=[UnregisterEventHandler(handler), after]),
    )
    assert code == 0
    assert _logged_messages(capsys) == ["ping"]


def test_a_handler_may_run_once(capsys: pytest.CaptureFixture[str]) -> None:
    done = LogInfo(msg="a")
    handler = OnExecutionComplete(
        target_action=done, on_completion=[LogInfo(msg="done")], handle_once=True
    )
    assert _run(RegisterEventHandler(handler), done, done) == 0
    assert _logged_messages(capsys) == ["a", "a", "done"]


def test_a_process_can_be_written_to_and_stopped(capsys: pytest.CaptureFixture[str]) -> None:
    reader = _python("print('got ' + input()); import time; time.sleep(60)", name="reader")

    def write(event: Any, _: LaunchContext) -> list[EmitEvent]:
        given = ProcessStdin(action=reader, name="", cmd=[], cwd=None, env=None, pid=event.pid)
        given.text = b"hello\n"
        return [EmitEvent(event=given)]

    stop = EmitEvent(event=ShutdownProcess(process_matcher=matches_name("reader")))
    code = _run(
        reader,
        RegisterEventHandler(OnProcessStart(target_action=reader, on_start=write)),
        RegisterEventHandler(OnProcessIO(on_stdout=lambda _: stop)),
    )
    assert code == 0
    assert "[reader-1] got hello" in capsys.readouterr().out


def test_output_of_a_process_can_be_cached() -> None:
    process = _python("import sys; print('out'); print('err', file=sys.stderr)", cached_output=True)
    assert _run(process) == 0
    assert (process.get_stdout(), process.get_stderr()) == (b"out\n", b"err\n")
    assert process.return_code == 0


def test_processes_follow_one_another(capsys: pytest.CaptureFixture[str]) -> None:
    second = _python("print('second')", name="second")
    first = _python("print('first')", name="first", on_exit=[second])
    handler = OnProcessExit(target_action=second, on_exit=Shutdown(reason="all done"))
    assert _run(RegisterEventHandler(handler), first, _python("import time; time.sleep(60)")) == 0
    out = capsys.readouterr().out
    assert out.index("[first-1] first") < out.index("[second-3] second")


@pytest.mark.parametrize(
    ("on_exit", "ends"),
    [
        (LaunchConfiguration("end"), True),
        ([LaunchConfiguration("end"), None], True),
        ("shutdown", True),
        (LaunchConfiguration("no_end"), False),
        ([], False),
    ],
    ids=["substitution", "list", "text", "empty substitution", "empty list"],
)
def test_on_exit_can_be_a_text(on_exit: Any, ends: bool) -> None:
    first = _python("", name="first", on_exit=on_exit)
    reasons: list[str] = []
    code = _run(
        SetLaunchConfiguration("end", "shutdown"),
        SetLaunchConfiguration("no_end", ""),
        RegisterEventHandler(OnShutdown(on_shutdown=lambda event, _: reasons.append(event.reason))),
        first,
    )
    assert code == 0
    assert ("process ended" in reasons) is ends


def test_a_wrong_text_in_on_exit_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert _run(_python("", name="first", on_exit=TextSubstitution(text="stop"))) == 1
    text = "on_exit must be an action, 'shutdown' or an empty text, not str: 'stop'"
    assert text in "".join(capsys.readouterr())


def test_the_service_runs_in_a_thread_until_its_shutdown() -> None:
    service = LaunchService(noninteractive=True)
    codes: list[int] = []
    thread = threading.Thread(target=lambda: codes.append(service.run(shutdown_when_idle=False)))
    thread.start()
    started = threading.Event()
    service.include_launch_description(
        LaunchDescription([OpaqueFunction(function=lambda _: started.set())])
    )
    assert started.wait(5)
    service.shutdown()
    thread.join(5)
    assert codes == [0]


@pytest.mark.parametrize("code", [0, 3])
def test_a_failed_program_is_not_a_failure_of_the_launch(code: int) -> None:
    service = LaunchService(noninteractive=True)
    service.include_launch_description(LaunchDescription([_python(f"raise SystemExit({code})")]))
    assert service.run() == 0
    assert service.context.program_failed is bool(code)


@pytest.mark.usefixtures("domain")
def test_managed_nodes_change_their_state_and_report_it(capsys: pytest.CaptureFixture[str]) -> None:
    node = LifecycleNode(package="zbot", executable="lifecycle_talker", name="lc", namespace="")

    def change(number: int) -> EmitEvent:
        matcher = matches_action(node)
        return EmitEvent(event=ChangeState(lifecycle_node_matcher=matcher, transition_id=number))

    code = _run(
        node,
        change(_CONFIGURE),
        RegisterEventHandler(
            OnStateTransition(
                target_lifecycle_node=node,
                goal_state="inactive",
                entities=[LogInfo(msg="inactive"), change(_ACTIVATE)],
            )
        ),
        RegisterEventHandler(
            OnStateTransition(
                start_state="activating",
                goal_state="active",
                entities=[
                    LogInfo(msg="active"),
                    RosTimer(period=0.01, actions=[Shutdown(reason="done")]),
                ],
            )
        ),
    )
    assert code == 0
    assert _logged_messages(capsys) == ["inactive", "active"]


@pytest.mark.parametrize(
    ("module", "names"),
    [
        ("launch", "LaunchDescription LaunchService LaunchContext LaunchIntrospector actions"),
        ("launch.actions", "DeclareLaunchArgument ExecuteProcess OpaqueFunction TimerAction"),
        ("launch.actions.execute_process", "ExecuteProcess"),
        ("launch.conditions", "IfCondition UnlessCondition LaunchConfigurationEquals"),
        ("launch.event_handlers", "OnProcessExit OnProcessIO OnProcessStart OnShutdown"),
        ("launch.event_handlers.on_process_start", "OnProcessStart"),
        ("launch.events", "Shutdown matches_action process"),
        ("launch.events.process", "ProcessStarted ProcessExited SignalProcess matches_action"),
        ("launch.frontend", "Entity Parser expose_action"),
        ("launch.launch_description_sources", "PythonLaunchDescriptionSource"),
        ("launch.logging", "get_logger launch_config"),
        ("launch.some_substitutions_type", "SomeSubstitutionsType"),
        ("launch.substitutions", "LaunchConfiguration PathJoinSubstitution SubstitutionFailure"),
        ("launch.utilities", "perform_substitutions normalize_to_list_of_substitutions"),
        ("launch_ros", "actions substitutions descriptions"),
        ("launch_ros.actions", "Node PushRosNamespace PushROSNamespace SetParameter ROSTimer"),
        ("launch_ros.descriptions", "ComposableNode ParameterValue ParameterFile"),
        ("launch_ros.event_handlers", "OnStateTransition"),
        ("launch_ros.events.lifecycle", "ChangeState StateTransition"),
        ("launch_ros.parameter_descriptions", "ParameterValue ParameterFile"),
        ("launch_ros.substitutions", "FindPackageShare FindPackage ExecutableInPackage Parameter"),
        ("launch_testing.actions", "ReadyToTest"),
        ("launch_xml.launch_description_sources", "XMLLaunchDescriptionSource"),
        ("launch_yaml.launch_description_sources", "YAMLLaunchDescriptionSource"),
    ],
)
def test_ros2s_names_are_importable(module: str, names: str) -> None:
    zbot.compat.install_names()
    imported = importlib.import_module(module)
    for name in names.split():
        assert getattr(imported, name) is not None


def test_installed_packages_are_imported_unless_zbots_are_preferred(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "launch_yaml").mkdir()
    (tmp_path / "launch_yaml" / "__init__.py").touch()
    (tmp_path / "launch_xml").mkdir()  # a folder of that name that is not a package
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr(zbot.compat, "_preferred", set())
    monkeypatch.setattr("zbot.package.import_finder._prefers_zbot", False)
    monkeypatch.delitem(sys.modules, "launch_yaml", raising=False)
    monkeypatch.delitem(sys.modules, "launch_xml", raising=False)
    zbot.compat.install_names()
    assert _origin("launch_yaml").is_relative_to(tmp_path)
    assert not _origin("launch_xml").is_relative_to(tmp_path)
    zbot.compat.install_names({"launch_yaml"})
    assert not _origin("launch_yaml").is_relative_to(tmp_path)


def _origin(name: str) -> Path:
    spec = importlib.util.find_spec(name)
    assert spec is not None
    assert spec.origin is not None
    return Path(spec.origin)


@pytest.mark.usefixtures("domain")
def test_the_node_of_a_launch_can_be_started_again() -> None:
    adapter = LaunchNode()
    first, fired = adapter.ros_node, threading.Event()
    assert first is not None
    first.create_timer(0.001, fired.set)
    assert fired.wait(5)
    adapter.shutdown()
    adapter.shutdown()
    assert adapter.ros_node is None
    with pytest.raises(ExternalShutdownException):
        adapter.node.get_name()
    adapter.start()
    assert adapter.ros_node not in {None, first}
    adapter.shutdown()
