"""Tests of `zbot run`: nodes by name, by package and by path."""

from __future__ import annotations

import signal
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start

SETUP = """
from setuptools import setup
package_name = 'my_robot'
setup(name=package_name, entry_points={
    'console_scripts': [
        'hello = my_robot.hello:main',
        f'named = {package_name}.hello:main',
        package_name + '_node = my_robot.hello:main',
    ],
})
"""
HELLO = """
import sys
from my_robot.words import GREETING

def main():
    print(GREETING, *sys.argv[1:], flush=True)
    return 3 if 'fail' in sys.argv else None
"""


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Return a workspace with one ament_python package that is not built."""
    package = tmp_path / "ws" / "src" / "my_robot"
    module = package / "my_robot"
    module.mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>my_robot</name></package>")
    (package / "setup.py").write_text(SETUP)
    (module / "__init__.py").touch()
    (module / "hello.py").write_text(HELLO)
    (module / "words.py").write_text("GREETING = 'hello from my_robot'\n")
    return tmp_path / "ws"


@pytest.mark.parametrize(
    ("name", "folder"),
    [
        ("hello", "."),
        ("named", "src"),
        ("my_robot_node", "src/my_robot"),
        ("hello", "src/my_robot/my_robot"),
    ],
)
def test_a_package_of_the_workspace_runs_unbuilt(workspace: Path, name: str, folder: str) -> None:
    done = zbot("run", "my_robot", name, "a", "--ros-args", "-r", "x:=y", cwd=workspace / folder)
    assert done.out == "hello from my_robot a --ros-args -r x:=y\n"
    assert done.code == 0


def test_the_exit_code_is_that_of_the_program(workspace: Path) -> None:
    assert zbot("run", "my_robot", "hello", "fail", cwd=workspace).code == 3


def test_a_file_runs_as_main(tmp_path: Path) -> None:
    (tmp_path / "hi.py").write_text(
        "import sys\nfrom std_msgs.msg import String\nprint(__name__, String(data='x'), sys.argv)\n"
    )
    done = zbot("run", "hi.py", "-v", cwd=tmp_path)
    assert done.out == "__main__ std_msgs.msg.String(data='x') ['hi.py', '-v']\n"


def test_a_prefix_is_put_before_the_program(tmp_path: Path) -> None:
    (tmp_path / "hi.py").write_text("import os\nprint(os.environ['GREETING'])\n")
    assert zbot("run", "--prefix", "env GREETING='good day'", "hi.py", cwd=tmp_path).out == (
        "good day\n"
    )


@pytest.mark.usefixtures("domain")
def test_names_can_be_remapped(start: Start) -> None:
    talker = start(
        "zbot", "run", "talker", "--ros-args",
        "-r", "__node:=bob", "-r", "__ns:=/lab", "-r", "chatter:=words",
    )  # fmt: skip
    talker.wait_for("[lab.bob]: Publishing")
    assert zbot("node", "list").out == "/lab/bob\n"
    assert "/lab/words\n" in zbot("topic", "list").out
    assert zbot("topic", "echo", "/lab/words", "--once", "--field", "data").out.startswith("Hello")


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, -signal.SIGINT), (signal.SIGTERM, -signal.SIGTERM)]
)
def test_a_signal_ends_a_program_without_output(start: Start, number: int, code: int) -> None:
    talker = start("zbot", "run", "talker")
    talker.wait_for("Publishing")
    assert talker.stop(number) == code
    assert all("[INFO]" in line for line in talker.lines)


def test_malformed_ros_args_are_refused(start: Start) -> None:
    talker = start("zbot", "run", "talker", "--ros-args", "-r", "chatter=words")
    assert talker.wait() == 1
    assert "chatter=words" in talker.output


SHARE = """
import os
from ament_index_python.packages import get_package_share_directory
from my_robot.msg import Beep
os.chdir('/')
print(get_package_share_directory('my_robot'), Beep(times=2))
"""


def test_a_program_finds_its_package_from_any_folder(workspace: Path, tmp_path: Path) -> None:
    folder = workspace / "src" / "my_robot"
    (folder / "msg").mkdir()
    (folder / "msg" / "Beep.msg").write_text("int32 times\n")
    (folder / "my_robot" / "share.py").write_text(SHARE)
    expected = f"{folder} my_robot.msg.Beep(times=2)\n"
    # The program is given by its path, from a folder outside of the workspace.
    assert zbot("run", str(folder / "my_robot" / "share.py"), cwd=tmp_path).out == expected


@pytest.mark.parametrize(
    ("target", "reason"),
    [
        ("my_robot.nowhere:main", "there is no module my_robot.nowhere"),
        ("nobody.hello:main", "there is no module nobody"),
        ("my_robot.hello:mian", "my_robot.hello has no mian()"),
        ("my_robot/hello:main", "write my_robot.hello:main in setup.py"),
        ("my_robot.hello:main()", "write my_robot.hello:main in setup.py"),
        ("my_robot.hello.py:main", "write my_robot.hello:main in setup.py"),
        ("my_robot.hello", "write my_robot.hello:main in setup.py"),
    ],
)
def test_an_entry_point_to_nothing_is_refused(workspace: Path, target: str, reason: str) -> None:
    setup = workspace / "src" / "my_robot" / "setup.py"
    setup.write_text(SETUP.replace("my_robot.hello:main", target, 1))
    done = zbot("run", "my_robot", "hello", cwd=workspace)
    assert (done.code, done.out) == (1, "")
    assert done.err.startswith(
        f"cannot run my_robot hello ({target}): {reason}\n\nhint: run `zbot build`"
    )


def test_a_failed_import_in_the_program_is_a_traceback(start: Start, workspace: Path) -> None:
    (workspace / "src" / "my_robot" / "my_robot" / "words.py").write_text("import no_such_thing\n")
    program = start("zbot", "run", "hello", env={"ZBOT_WORKSPACE": str(workspace)})
    program.wait_for("ModuleNotFoundError: No module named 'no_such_thing'")
    assert program.wait() == 1
