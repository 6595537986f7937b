"""Tests of the start and the end of a program in the process of `zbot run`."""

from __future__ import annotations

import signal
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from zbot.errors.installation import pip_install

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start

NODE_CLASS = """
import zbot
NAME = 'n'

class N(zbot.Node):
    def __init__(self):
        super().__init__(NAME)
        print('started', flush=True)
"""


def test_output_of_a_program_is_not_buffered(start: Start, tmp_path: Path) -> None:
    (tmp_path / "wait.py").write_text("print('ready')\nwhile True: pass\n")
    program = start("zbot", "run", "wait.py")
    program.wait_for("ready")
    assert program.stop(signal.SIGINT) != 0
    assert program.output == "ready"


@pytest.mark.parametrize(
    ("source", "reason", "advice"),
    [
        ("def main(args=None):\n    print('started')\n", "main() is never called", "write main()"),
        (NODE_CLASS, "the class N is never used", "write zbot.init() and zbot.spin(N())"),
    ],
)
def test_a_file_that_only_defines_a_node_is_started_with_a_note(
    start: Start, tmp_path: Path, source: str, reason: str, advice: str
) -> None:
    (tmp_path / "sheet.py").write_text(source)
    program = start("zbot", "run", "sheet.py")
    program.wait_for("started")
    (note,) = (line for line in program.lines if line.startswith("note: "))
    assert note == (
        f"note: sheet.py: {reason}; `zbot run` starts it, but `python` does not: "
        f"{advice} at the end of the file"
    )


def test_a_file_with_a_main_block_is_started_once(start: Start, tmp_path: Path) -> None:
    source = "def main():\n    print('started')\n\nif __name__ == '__main__':\n    main()\n"
    (tmp_path / "own.py").write_text(source)
    program = start("zbot", "run", "own.py")
    assert program.wait() == 0
    assert program.output == "started"


def test_a_file_with_nothing_to_start_is_reported(start: Start, tmp_path: Path) -> None:
    (tmp_path / "parts.py").write_text("def helper(): ...\n")
    program = start("zbot", "run", "parts.py")
    assert program.wait() == 1
    assert program.lines[0].startswith("parts.py has nothing to run")


def test_a_traceback_begins_at_the_users_line(start: Start, tmp_path: Path) -> None:
    (tmp_path / "fails.py").write_text("def main():\n    return 1 / 0\n\nmain()\n")
    program = start("zbot", "run", "fails.py")
    assert program.wait() == 1
    assert program.lines[0] == "Traceback (most recent call last):"
    assert program.lines[1] == '  File "fails.py", line 4, in <module>'
    assert program.lines[-1] == "ZeroDivisionError: division by zero"


def test_a_missing_library_is_one_sentence(start: Start, tmp_path: Path) -> None:
    source = "import sys\nsys.modules['transforms3d'] = None\nimport tf_transformations\n"
    (tmp_path / "turn.py").write_text(source)
    program = start("zbot", "run", "turn.py")
    assert program.wait() == 1
    assert program.output == f"tf_transformations needs transforms3d: {pip_install('zbot[numpy]')}"


def test_a_syntax_error_is_shown_as_python_shows_it(start: Start, tmp_path: Path) -> None:
    (tmp_path / "bad.py").write_text("def main(:\n")
    program = start("zbot", "run", "bad.py")
    assert program.wait() == 1
    assert program.lines[0] == '  File "bad.py", line 1'
    assert program.lines[-1].startswith("SyntaxError: ")


@pytest.mark.parametrize(
    ("source", "text"),
    [
        ("print(“hi”)", 'type " in place of “ (U+201C)'),
        ("zbot.Node()", "'node_name': write the node's name, e.g. super().__init__('my_node')"),
        (
            "Mine = type('Mine', (zbot.Node,), {'_init_': print}); Mine()",
            "the class Mine has `_init_`: write `__init__`",
        ),
        ("zbot.Node('a').create_publisher(String, 't')", "write the depth of the queue, e.g. 10"),
        ("zbot.spin()", "missing 1 required positional argument: 'node': write the node"),
        ("print(String().text)", "'String' object has no attribute 'text'; it has data"),
    ],
)
def test_the_report_of_a_mistake_says_what_to_write(tmp_path: Path, source: str, text: str) -> None:
    program = tmp_path / "mistake.py"
    lines = f"import zbot\nfrom std_msgs.msg import String\nzbot.init()\n{source}\n"
    program.write_text(lines, encoding="utf-8")
    command = [sys.executable, "-m", "zbot_cli", "run", str(program)]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60, check=False)
    assert done.returncode == 1
    assert "line 4" in done.stderr
    assert text in done.stderr.splitlines()[-1]


def test_a_program_can_import_a_file_beside_it(tmp_path: Path) -> None:
    (tmp_path / "code").mkdir()
    (tmp_path / "code" / "a.py").write_text("import b\nprint(b.WORD)\n")
    (tmp_path / "code" / "b.py").write_text("WORD = 'found'\n")
    assert zbot("run", "code/a.py", cwd=tmp_path).out == "found\n"


def test_a_file_in_the_folder_cannot_replace_a_module(start: Start, tmp_path: Path) -> None:
    (tmp_path / "random.py").write_text("raise SystemExit('the wrong one')\n")
    source = f"import sys; sys.path[0] = {str(tmp_path)!r}; from zbot_cli.main import main; main()"
    start(sys.executable, "-c", source, "run", "sensor").wait_for("Temperature sensor started")


def test_a_file_that_hides_a_module_of_python_is_named(tmp_path: Path) -> None:
    (tmp_path / "colorsys.py").write_text("COLOURS = 7\n")
    (tmp_path / "node.py").write_text("import colorsys\nprint(colorsys.COLOURS)\n")
    done = zbot("run", str(tmp_path / "node.py"))
    hides = f"the file {tmp_path / 'colorsys.py'} hides Python's module colorsys: rename it\n"
    assert (done.code, done.out, done.err) == (0, "7\n", hides)


def test_a_file_that_python_does_not_import_is_named(tmp_path: Path) -> None:
    (tmp_path / "types.py").write_text("")
    (tmp_path / "enum.py").write_text("")  # nobody asks for it
    (tmp_path / "node.py").write_text("from types import SimpleNamespace\nprint('works')\n")
    done = zbot("run", str(tmp_path / "node.py"))
    reason = "is not imported, because Python uses its own module types: rename the file"
    assert (done.code, done.out) == (0, "works\n")
    assert done.err == f"{tmp_path / 'types.py'} {reason}\n"
