"""Tests of what surrounds every command: nouns, verbs, errors, signals and streams."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from zbot.errors import ZbotError
from zbot_cli import main as main_module
from zbot_cli.main import NOUNS, main, run_command
from zbot_cli.nouns import load, verbs
from zbot_cli.output.exit_status import Status
from zbot_cli.output.standard_streams import report

if TYPE_CHECKING:
    from pathlib import Path

    from tests.cli.conftest import Command, Write
    from tests.conftest import Start

#: Options that take several words, which `ManyValuesCommand` reads, and the end of the options.
MANY = {"--", "--dependencies", "--packages-select"}
LOADED = sorted(set(NOUNS) - {"run"})


class LostError(ZbotError):
    def __init__(self, hint: str | None = None) -> None:
        super().__init__("the robot is lost", hint=hint)


def test_version_prints_the_facts_that_a_bug_report_needs(zbot_command: Command) -> None:
    result = zbot_command("--version")
    assert (result.code, result.err) == (0, "")
    for word in ("zbot ", "eclipse-zenoh ", "Python ", "."):
        assert word in result.out
    assert result.out.count("\n") == 1


@pytest.mark.parametrize("noun", LOADED)
def test_every_noun_has_help_of_short_phrases(zbot_command: Command, noun: str) -> None:
    result = zbot_command(noun, "-h")
    assert (result.code, result.err) == (0, "")
    assert result.out.startswith(f"Usage: zbot {noun}")
    for name, verb in verbs(load(noun)).items():
        assert verb.hidden or verb.short_help in result.out, name
        assert not verb.short_help.endswith(".")
        assert len(verb.short_help.split()) <= 8


@pytest.mark.parametrize("noun", LOADED)
def test_every_verb_has_help_and_describes_its_options(zbot_command: Command, noun: str) -> None:
    command = load(noun)
    for name, verb in (verbs(command) or {"": command}).items():
        words = [noun, name] if name else [noun]
        result = zbot_command(*words, "--help")
        assert result.code == 0
        if not verb.hidden:
            example = result.out.rpartition("  Example:\n    ")[2]
            assert example.startswith(f"zbot {' '.join(words)}"), example
            known = {text for option in verb.params for text in option.opts}
            assert {word for word in example.split() if word.startswith("--")} <= known | MANY
        for option in verb.params:
            assert option.help, f"{noun} {name} {option.name}"


@pytest.mark.parametrize("noun", ["topic", "node", "interface", "daemon"])
def test_a_noun_without_a_verb_prints_its_help(zbot_command: Command, noun: str) -> None:
    result = zbot_command(noun)
    assert (result.code, result.err) == (0, "")
    assert "Commands:" in result.out


def test_descriptions_of_nouns_are_short() -> None:
    for text in NOUNS.values():
        assert len(text.split()) <= 8
        assert not text.endswith(".")


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["frobnicate"], "No such command 'frobnicate'."),
        (["nod"], "Did you mean 'node'?"),
        (["topci"], "Did you mean 'topic'?"),
        (["rqt_graph"], "Type 'zbot web graph'"),
        (["colcon", "build"], "Type 'zbot build'"),
        (["rviz2"], "Type 'zbot view'"),
        (["ros2", "topic", "list"], "Leave out 'ros2'"),
        (["setup-shell", "tcsh"], "choose from bash, zsh, fish, powershell"),
        (["topic", "frobnicate"], "No such command 'frobnicate'."),
        (["topic", "ehco"], "Did you mean 'echo'?"),
        (["interface", "show"], "Missing argument"),
        (["node", "list", "/rosout"], "unexpected extra argument"),
        (["--config"], "Option '--config' requires a file."),
        (["topic", "list", "--nope"], "No such option: --nope"),
        (["--nope"], "No such option: --nope"),
        (["topic", "pub", "-1", "-t", "2", "/x"], "exclude each other"),
        (["topic", "echo", "/x", "std_msgs/msg/String", "--qos-profile", "fast"], "no profile"),
    ],
)
def test_wrong_command_lines_are_refused(
    zbot_command: Command, words: list[str], text: str
) -> None:
    result = zbot_command(*words)
    assert (result.code, result.out) == (2, "")
    assert text in result.err
    assert "-h' for help" in result.err or "--help' for help" in result.err


@pytest.mark.parametrize(
    ("words", "sentence", "hint"),
    [
        (["node", "info", "/nobody"], "Unable to find node '/nobody'", None),
        (["topic", "info", "/nothing"], "Unknown topic '/nothing'", None),
        (["interface", "show", "nope/msg/Nope"], "Unknown package 'nope'", None),
        (["interface", "show", "String"], "Invalid name 'String'. Expected three", "std_msgs"),
        (
            ["interface", "show", "std_msgs/msg/Strin"],
            "Interface 'msg/Strin' not",
            "std_msgs/msg/String",
        ),
        (
            ["topic", "pub", "--once", "/x", "std_msgs/msg/Strin", "{data: hello}"],
            "The passed message type is invalid",
            "std_msgs/msg/String",
        ),
        (
            ["topic", "pub", "--once", "/x", "std_msgs/msg/String", "{dat: hello}"],
            "Failed to populate field: 'String' object has no attribute 'dat'",
            "did you mean 'data'?",
        ),
        (
            ["topic", "pub", "--once", "/x", "std_msgs/msg/Float32", "{data:1}"],
            "Failed to populate field",
            "put a blank after the colon: data: 1",
        ),
        (["topic", "pub", "-r", "0", "/x", "std_msgs/msg/Empty"], "must be positive", None),
        (
            ["topic", "pub", "--max-wait-time-secs", "1", "/x", "std_msgs/msg/Empty"],
            "--max-wait-time-secs option is only effective",
            None,
        ),
    ],
)
@pytest.mark.usefixtures("domain")
def test_an_error_is_one_sentence_and_exits_with_one(
    zbot_command: Command, words: list[str], sentence: str, hint: str | None
) -> None:
    result = zbot_command(*words)
    assert (result.code, result.out) == (1, "")
    assert sentence in result.err
    if hint is not None:
        assert hint in result.err.partition("hint: ")[2]


def test_an_error_is_a_sentence_and_a_hint(capsys: pytest.CaptureFixture[str]) -> None:
    assert report(LostError()) is Status.ERROR
    assert capsys.readouterr().err == "the robot is lost\n"
    report(LostError("look for it"))
    assert capsys.readouterr().err == "the robot is lost\n\nhint: look for it\n"


def test_debug_shows_where_an_error_comes_from() -> None:
    with pytest.raises(ZbotError, match="Unknown package 'nope'"):
        run_command(["--debug", "interface", "show", "nope/msg/Nope"])


@pytest.mark.parametrize("sets", [["--config", "my.json5"], ["--config=my.json5"]])
def test_config_applies_to_one_command(
    zbot_command: Command, monkeypatch: pytest.MonkeyPatch, sets: list[str]
) -> None:
    monkeypatch.setenv("ZBOT_CONFIG", "other.json5")
    assert zbot_command(*sets, "daemon", "status").code == 0
    assert os.environ["ZBOT_CONFIG"] == "my.json5"


def test_ctrl_c_in_a_command_gives_its_exit_code(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(_: list[str]) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr(main_module, "_run_noun", interrupted)
    assert run_command(["topic", "list"]) == Status.INTERRUPTED


def test_an_internal_error_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    def wrong(_: list[str]) -> int:
        raise ZeroDivisionError

    monkeypatch.setattr(main_module, "_run_noun", wrong)
    with pytest.raises(ZeroDivisionError):
        run_command(["topic", "list"])


def test_main_exits_with_the_code_of_the_command(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["zbot", "daemon", "status"])
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 0


@pytest.mark.parametrize("verb", ["status", "start", "stop"])
def test_the_daemon_verbs_are_accepted(zbot_command: Command, verb: str) -> None:
    result = zbot_command("daemon", verb)
    assert (result.code, result.err) == (0, "")
    assert result.out == (
        "zbot has no daemon and needs none: every command sees the running nodes directly\n"
    )


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, Status.INTERRUPTED), (signal.SIGTERM, Status.TERMINATED)]
)
@pytest.mark.usefixtures("domain")
def test_a_signal_ends_a_command_without_output(start: Start, number: int, code: Status) -> None:
    echo = start("zbot", "topic", "echo", "/nothing")
    echo.wait_for("waiting for /nothing")
    # A shell sees the same number for an end by the signal and for the exit code.
    assert echo.stop(number) in {code, -number}
    assert echo.lines == ["waiting for /nothing to appear"]


def test_help_imports_neither_typer_nor_zenoh() -> None:
    source = (
        "import sys\nfrom zbot_cli.main import run_command\n"
        "try:\n    run_command(['--help'])\nexcept SystemExit:\n    pass\n"
        "print(sorted({'zenoh', 'typer', 'rich', 'yaml', 'asyncio', 'zbot'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", source], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "[]"


def test_no_noun_imports_rich() -> None:
    source = (
        "import sys\nfrom zbot_cli.main import run_command\n"
        f"for noun in {LOADED!r}:\n    run_command([noun, '--help'])\n"
        "    assert 'rich' not in sys.modules, noun\nprint('all')"
    )
    done = subprocess.run(
        [sys.executable, "-c", source], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "all"


@pytest.mark.parametrize("noun", ["topic", "node", "service", "action"])
def test_lists_load_no_definitions(domain: int, noun: str) -> None:  # noqa: ARG001 - by $
    source = (
        "import sys\nfrom zbot_cli.main import run_command\n"
        f"code = run_command([{noun!r}, 'list'])\n"
        "heavy = {'zbot.interfaces.registry', 'zbot.wire.messagepack.codec', 'hashlib'}\n"
        "print(int(code), heavy & set(sys.modules))"
    )
    done = subprocess.run(
        [sys.executable, "-c", source], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "0 set()"


# -- completion ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        (["na"], []),
        (["to"], ["topic"]),
        (["topic", "ec"], ["echo"]),
        (["topic", "echo", "--onc"], ["--once"]),
        (["interface", "show", "geometry_msgs/msg/TwistS"], ["geometry_msgs/msg/TwistStamped"]),
        (["run", "sens"], ["sensor"]),
        (["int"], ["interface"]),
        (["--v"], ["--version"]),
        (["interface", "pa"], ["package", "packages"]),
        (["interface", "package", "geometry"], ["geometry_msgs"]),
        (["interface", "show", "std_srvs/srv/E"], ["std_srvs/srv/Empty"]),
        (["interface", "show", "--no"], ["--no-comments"]),
        (["run", "demo_nodes_py", "t"], ["talker"]),
        (["run", "demo_nodes_py", "talker", "t"], []),
        (["completion", ""], ["bash", "fish", "powershell", "zsh"]),
        (["completion", '""'], ["bash", "fish", "powershell", "zsh"]),
        (["nonsense", "x"], []),
        (["topic", "nonsense", "x"], []),
        (["topic", "list", "--spin"], []),
        (["topic", "pub", "/x", "std_msgs/msg/String", ""], ['\'{"data": ""}\'']),
        (
            ["action", "send_goal", "/x", "example_interfaces/action/Fibonacci", ""],
            ["'{\"order\": 0}'"],
        ),
        (["topic", "echo", "--qos-profile", "sen"], ["sensor_data"]),
        (["topic", "pub", "--qos-reliability", ""], ["best_effort", "reliable"]),
        (
            ["topic", "echo", "/x", "geometry_msgs/msg/Twist", "--field", "linear"],
            ["linear", "linear.x", "linear.y", "linear.z"],
        ),
        (["topic", "pub", "--rate", "2", "/x", "std_srvs/ms"], []),
        (["topic", "pub", "--rate", "2", "/x", "std_msgs/msg/Strin"], ["std_msgs/msg/String"]),
        (["topic", "pub", "--rate", ""], []),
        (["pkg", "create", "--build-type", "ament_p"], ["ament_python"]),
        (["action", "find", "action_t"], ["action_tutorials_interfaces/action/Fibonacci"]),
    ],
)
def test_completion_offers_words(
    zbot_command: Command, words: list[str], wanted: list[str]
) -> None:
    result = zbot_command("complete", "--", *words)
    assert (result.code, result.err) == (0, "")
    assert result.out.splitlines() == wanted


def test_completion_of_launch_offers_files(
    zbot_command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("robo.launch.py", "robo_launch.xml", "robo.py", "robofolder/x.launch.yaml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    monkeypatch.chdir(tmp_path)
    found = zbot_command("complete", "--", "launch", "robo").out.split()
    files = ["robo.launch.py", "robo_launch.xml", "robofolder/"]
    names = ["robot", "robot_localization", "robot_state_publisher"]
    assert found == [*files, *names]
    found = zbot_command("complete", "--", "launch", "robofolder/").out.split()
    assert found == ["robofolder/x.launch.yaml"]
    found = zbot_command("complete", "--", "launch", f"{tmp_path}/robofo").out.split()
    assert found == [f"{tmp_path}/robofolder/"]


@pytest.mark.usefixtures("workspace")
def test_completion_of_build_offers_packages(zbot_command: Command, write: Write) -> None:
    write("robot")
    found = zbot_command("complete", "--", "build", "--packages-select", "")
    assert found.out == "robot\n"


@pytest.mark.usefixtures("workspace")
def test_completion_of_run_offers_nodes_and_packages(zbot_command: Command) -> None:
    found = zbot_command("complete", "--", "run", "").out.split()
    assert found == sorted(set(found))
    assert {"demo_nodes_cpp", "demo_nodes_py", "listener", "talker", "zbot_nodes"} <= set(found)


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish", "powershell"])
def test_completion_has_a_script_for_every_shell(zbot_command: Command, shell: str) -> None:
    assert "zbot complete -- " in zbot_command("completion", shell).out


def test_completion_refuses_an_unknown_shell(zbot_command: Command) -> None:
    result = zbot_command("completion", "tcsh")
    assert result.code == 2
    assert "choose from bash, zsh, fish, powershell" in result.err


# -- setup-shell -----------------------------------------------------------------------------------


def functions(shell: str, path: str, line: str) -> str:
    """Return what a shell prints for a line after the functions of `zbot setup-shell`."""
    program = shutil.which(shell)
    if program is None:
        pytest.skip(f"there is no {shell}")
    text = zbot("setup-shell", shell).out
    done = subprocess.run(
        [program, "-c", f"{text}\n{line}"],
        env={"PATH": f"{path}{os.pathsep}/usr/bin{os.pathsep}/bin"},
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stdout + done.stderr


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_words_of_ros2_run_zbot(tmp_path: Path, shell: str) -> None:
    _write_program(tmp_path / "zbot", "zbot")
    lines = "ros2 topic list; colcon build; rqt_graph; rviz2; rqt_plot /a/data; rqt_console"
    said = functions(shell, str(tmp_path), lines)
    assert said.splitlines() == [
        "zbot topic list",
        "zbot build",
        "zbot web graph",
        "zbot run rviz2 rviz2",
        "zbot run rqt_plot rqt_plot /a/data",
        "zbot run rqt_console rqt_console",
    ]


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_real_ros2_is_run_instead(tmp_path: Path, shell: str) -> None:
    for name in ("zbot", "ros2"):
        _write_program(tmp_path / name, name)
    assert functions(shell, str(tmp_path), "ros2 topic list") == "ros2 topic list\n"


def test_setup_shell_says_how_to_install_it(zbot_command: Command) -> None:
    lines = zbot_command("setup-shell").out
    for shell in ("bash", "zsh", "fish", "powershell"):
        assert f"zbot setup-shell {shell} >> " in lines
        assert zbot_command("setup-shell", shell).code == 0


def _write_program(path: Path, name: str) -> None:
    path.write_text(f'#!/bin/sh\necho {name} "$@"\n')
    path.chmod(0o755)
