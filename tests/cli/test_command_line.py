"""What every command has in common: help, errors, exit codes, and a quick start."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from pathlib import Path


def test_help_names_every_noun() -> None:
    done = zbot("--help")
    assert done.code == 0
    for noun in ("completion", "daemon", "doctor", "interface", "node", "run", "topic"):
        assert f"\n  {noun} " in done.out


def test_no_words_print_the_help() -> None:
    assert zbot().out == zbot("--help").out


@pytest.mark.parametrize("noun", ["topic", "node", "interface", "daemon"])
def test_a_noun_alone_prints_its_help(noun: str) -> None:
    done = zbot(noun)
    assert (done.code, done.err) == (0, "")
    assert "Commands:" in done.out


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["topik"], "No such command 'topik'. Did you mean 'topic'?"),
        (["topic", "lisst"], "No such command 'lisst'"),
        (["topic", "list", "--nope"], "No such option: --nope"),
        (["topic", "info"], "Missing argument"),
        (["--nope"], "No such option: --nope"),
        (["run"], "name a node to run"),
        (["topic", "pub", "-1", "-t", "2", "/x"], "exclude each other"),
        (["topic", "echo", "/x", "std_msgs/msg/String", "--qos-profile", "fast"], "no profile"),
    ],
)
@pytest.mark.usefixtures("domain")
def test_a_wrong_command_line_exits_with_two(words: list[str], text: str) -> None:
    done = zbot(*words)
    assert done.code == 2
    assert text in done.err


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
        (["run", "no_package", "node"], "Package 'no_package' not found", "zbot_nodes"),
        (["run", "zbot_nodes", "senzor"], "No executable found", "sensor"),
        (["run", "senzor"], "No executable found", "did you mean 'sensor'?"),
        (["run", "missing.py"], "File 'missing.py' not found", None),
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
    words: list[str], sentence: str, hint: str | None
) -> None:
    done = zbot(*words)
    assert done.code == 1
    assert sentence in done.err
    assert done.out == ""
    if hint is not None:
        assert hint in done.err.partition("hint: ")[2]


def test_a_domain_out_of_range_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZBOT_DOMAIN_ID", "300")
    done = zbot("topic", "list")
    assert done.code == 1
    assert done.err.startswith("ZBOT_DOMAIN_ID is '300', but a domain is a whole number from 0")


def test_a_wrong_configuration_is_told(tmp_path: Path) -> None:
    (tmp_path / "zenoh.json5").write_text("{ mode: 'pear' }", encoding="utf-8")
    done = zbot("topic", "list", cwd=tmp_path)
    assert done.code == 1
    assert "zenoh.json5: unknown variant `pear`" in done.err
    named = zbot("--config", str(tmp_path / "none.json5"), "topic", "list")
    assert named.code == 1
    assert "none.json5: No such file or directory" in named.err


def test_daemon_says_that_none_is_needed() -> None:
    for verb in ("status", "start", "stop"):
        done = zbot("daemon", verb)
        assert (done.code, done.err) == (0, "")
        assert "needs none" in done.out


def test_a_reader_that_leaves_is_no_error() -> None:
    script = f"{sys.executable} -m zbot_cli interface list | head -n 1"
    done = subprocess.run(["sh", "-c", script], capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("Messages:\n", "")


def test_help_starts_fast_without_zenoh_or_rich() -> None:
    code = (
        "import sys; sys.argv = ['zbot', '--help']\n"
        "from zbot_cli.main import main\n"
        "try:\n    main()\nexcept SystemExit:\n"
        "    print(sorted({'zenoh', 'rich', 'typer'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"
    begun = time.perf_counter()
    zbot("--help")
    assert time.perf_counter() - begun < 2  # 0.08 s where nothing else runs


INTERRUPTED_IMPORT = """
import builtins, runpy, signal, sys
real_import, module = builtins.__import__, sys.argv.pop(1)
def interrupted_import(name, *more, **named):
    if name == module:
        builtins.__import__ = real_import
        signal.raise_signal(signal.SIGINT)
    return real_import(name, *more, **named)
builtins.__import__ = interrupted_import
runpy.run_module("zbot_cli", run_name="__main__")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.parametrize(
    ("module", "words"),
    [
        ("zbot_cli.output.exit_status", ["--version"]),
        ("zbot_cli.commands.run", ["run", "talker"]),
        ("zbot.compat", ["run", "talker"]),
        ("zbot_cli.nouns", ["topic", "list"]),
    ],
)
def test_ctrl_c_while_the_command_is_being_loaded_is_quiet(module: str, words: list[str]) -> None:
    command = [sys.executable, "-c", INTERRUPTED_IMPORT, module, *words]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode in {-signal.SIGINT, Status.INTERRUPTED}
    assert (done.stdout, done.stderr) == ("", "")


INTERRUPTED_END = """
import runpy, signal, sys
from zbot_cli.input import interruption
end_at_once = interruption.end_at_once
def interrupted():
    if signal.getsignal(signal.SIGINT) is not signal.SIG_DFL:
        signal.raise_signal(signal.SIGINT)
    end_at_once()
end_at_once()
interruption.end_at_once = interrupted
runpy.run_module("zbot_cli", run_name="__main__")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_ctrl_c_between_a_command_and_the_end_is_quiet() -> None:
    command = [sys.executable, "-c", INTERRUPTED_END, "pkg", "prefix", "zbot_nodes"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (-signal.SIGINT, "")


DROPPED = """
import signal, time, weakref
from zbot_cli.input import interruption
interruption.end_at_once()
interruption.raise_exception()
thing = type("Thing", (), {})()
reference = weakref.ref(thing, lambda _: signal.raise_signal(signal.SIGINT))
try:
    del thing
    for _ in range(500):
        time.sleep(0.01)
except KeyboardInterrupt:
    print("heard")
"""


def test_ctrl_c_where_python_drops_exceptions_is_heard_in_a_moment() -> None:
    command = [sys.executable, "-c", DROPPED]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.stdout, done.stderr) == ("heard\n", "")


HANDLER_AT_THE_END = """
import runpy, signal, sys
real_exit = sys.exit
def exit(code):
    print(signal.getsignal(signal.SIGINT).name)
    real_exit(code)
sys.exit = exit
runpy.run_module("zbot_cli", run_name="__main__")
"""


@pytest.mark.usefixtures("domain")
@pytest.mark.parametrize("words", [["node", "list"], ["topic", "echo", "--timeout", "0", "/x"]])
def test_ctrl_c_behind_a_command_ends_the_process(words: list[str]) -> None:
    command = [sys.executable, "-c", HANDLER_AT_THE_END, *words]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.stdout.splitlines()[-1] == "SIG_DFL", done.stderr


def test_doctor_finds_nothing_wrong_on_a_healthy_machine(domain: int) -> None:
    done = zbot("doctor")
    assert (done.code, done.err) == (0, "")
    assert f"ok    domain: {domain}\n" in done.out
    assert done.out.endswith("checks passed\n")


def test_completion_knows_nouns_verbs_options_and_types() -> None:
    assert zbot("complete", "--", "to").out == "topic\n"
    assert zbot("complete", "--", "topic", "ec").out == "echo\n"
    assert "--once\n" in zbot("complete", "--", "topic", "echo", "--o").out
    types = zbot("complete", "--", "interface", "show", "geometry_msgs/msg/Tw").out.splitlines()
    assert "geometry_msgs/msg/Twist" in types
    assert zbot("complete", "--", "run", "sens").out == "sensor\n"


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish", "powershell"])
def test_completion_has_a_script_for_every_shell(shell: str) -> None:
    assert "zbot complete -- " in zbot("completion", shell).out


@pytest.mark.skipif(os.name == "nt", reason="bash is not part of Windows")
def test_bash_completes_a_verb() -> None:
    script = (
        f'eval "$({sys.executable} -m zbot_cli completion bash)"\n'
        f'zbot() {{ {sys.executable} -m zbot_cli "$@"; }}\n'
        "COMP_WORDS=(zbot topic ec); COMP_CWORD=2; _zbot_complete; echo ${COMPREPLY[@]}"
    )
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout == "echo\n"
