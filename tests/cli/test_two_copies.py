"""Tests of two workspaces below one folder `src` with packages of the same name."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from zbot.interfaces.location import definition_file
from zbot.package import package_share, python_finder
from zbot.package.workspace import build_roots, packages_by_name
from zbot_cli.packages.launch_file import in_package

if TYPE_CHECKING:
    from pathlib import Path

    from tests.cli.conftest import Command

SETUP = "setup(name='bot', entry_points={'console_scripts': ['hi = bot.hi:main']})\n"
HI = """
import subprocess, sys
from bot import PLACE
def main():
    print(PLACE, flush=True)
    if "child" in sys.argv:
        subprocess.run([sys.executable, "-c", "import bot; print('child', bot.PLACE)"])
"""
LAUNCH = """
import bot
from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node
def generate_launch_description():
    options = {"package": "bot", "executable": "hi", "output": "screen"}
    return LaunchDescription([
        LogInfo(msg=f"file {bot.PLACE}"),
        Node(**options),
        Node(**options, cwd=OTHER, exec_name="elsewhere"),
    ])
"""
TEST = (
    "from bot import PLACE\nprint('tested', PLACE)\ndef test_place():\n    assert PLACE == 'L2'\n"
)
#: Folders of the second workspace in which its copy must be used.
FOLDERS = ("L2/ws", "L2/ws/src", "L2/ws/src/bot", "L2/ws/src/bot/bot", "L2/ws/src/bot/launch", "L2")


@pytest.fixture
def src(tmp_path: Path) -> Path:
    """Return the outer folder `src`, with the workspaces L1/ws and L2/ws."""
    src = tmp_path / "src"
    for place in ("L1", "L2"):
        other = src / ("L2" if place == "L1" else "L1") / "ws"
        for name, text in {
            "package.xml": "<package><name>bot</name></package>",
            "setup.py": SETUP,
            "bot/__init__.py": f"PLACE = '{place}'\n",
            "bot/hi.py": HI,
            "msg/Place.msg": f"int32 in_{place.lower()}\n",
            "launch/all.launch.py": LAUNCH.replace("OTHER", repr(str(other))),
            "test/test_place.py": TEST,
        }.items():
            path = src / place / "ws" / "src" / "bot" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    return src


@pytest.fixture(params=FOLDERS)
def inside(request: pytest.FixtureRequest, src: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Change into a folder of the second workspace. Return the second copy of the package."""
    monkeypatch.chdir(src / request.param)
    monkeypatch.delenv("ZBOT_WORKSPACE", raising=False)
    return src / "L2" / "ws" / "src" / "bot"


def test_the_nearest_copy_is_used(
    inside: Path, zbot_command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert package_share("bot") == inside
    assert in_package("bot", "all.launch.py") == inside / "launch" / "all.launch.py"
    assert definition_file("bot", "msg", "Place") == inside / "msg" / "Place.msg"
    assert zbot_command("pkg", "executables", "bot", "--full-path").out == f"{inside}/bot/hi.py\n"
    found = zbot_command("run", "--where", "bot", "hi")
    assert found.out == f"{inside}/bot/hi.py\n"
    assert found.err.startswith("note: package 'bot' is also in ")
    assert f"; this is the one in {inside}" in found.err
    monkeypatch.setattr(python_finder, "_searches_always", True)
    spec = python_finder.find_package("bot")
    assert spec is not None
    assert spec.origin == f"{inside}/bot/__init__.py"


def test_a_sourced_workspace_is_not_nearer(
    inside: Path, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_WORKSPACE", str(src / "L1" / "ws" / "src"))
    if not str(inside).startswith(f"{src / 'L2'}/ws"):
        pytest.skip("this folder is in no workspace of its own")
    assert package_share("bot") == inside


def test_only_the_nearest_workspace_is_built(src: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(src / "L2" / "ws")
    assert packages_by_name(build_roots()) == {"bot": [src / "L2" / "ws" / "src" / "bot"]}


def test_a_package_of_an_outer_workspace_is_found(
    src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (src / "base").mkdir()
    (src / "base" / "package.xml").write_text("<package><name>base</name></package>")
    monkeypatch.chdir(src / "L2" / "ws")
    assert package_share("base") == src / "base"


@pytest.mark.parametrize("folder", ["L2/ws", "L2/ws/src/bot/bot"])
def test_a_program_and_its_children_import_the_nearest_copy(src: Path, folder: str) -> None:
    result = zbot("run", "bot", "hi", "child", cwd=src / folder)
    assert result.out.split("\n") == ["L2", "child L2", ""]
    assert result.err.count("note: package 'bot' is also in ") == 1


def test_a_launch_uses_the_nearest_copy_also_for_nodes_in_other_folders(src: Path) -> None:
    result = zbot("launch", "bot", "all.launch.py", cwd=src / "L2" / "ws")
    text = result.out + result.err
    assert "file L2" in text
    assert "[hi-1] L2" in text
    assert "[elsewhere-2] L2" in text
    assert text.count("package 'bot' is also in ") == 1


def test_tests_import_the_nearest_copy(src: Path) -> None:
    for words in (("test",), ("test", "--packages-select", "bot")):
        result = zbot(*words, cwd=src / "L2" / "ws")
        assert result.code == 0, result.out


def test_where_prints_files_of_all_kinds(
    src: Path, monkeypatch: pytest.MonkeyPatch, zbot_command: Command
) -> None:
    monkeypatch.chdir(src / "L2" / "ws")
    (src / "L2" / "ws" / "x.py").touch()
    assert zbot_command("run", "--where", "./x.py").out == f"{src}/L2/ws/x.py\n"
    assert zbot_command("run", "--where", "talker").out.endswith("talker.py\n")
