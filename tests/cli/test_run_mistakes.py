"""Tests for mistakes on the command line of `zbot run`, and in the files that it runs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from zbot_cli.commands.run.script import NothingToRunError, run_script

if TYPE_CHECKING:
    from tests.cli.conftest import Command, Write

_CMAKE = "add_executable(drive src/drive.cpp)\n"


@pytest.fixture
def files(write: Write) -> None:
    write(
        "robot", scripts="'drive = robot.drive:main'", **{"robot/drive.py": "", "launch/a.xml": ""}
    )
    write("arm", scripts="'lift = arm.lift:main' 'drop = arm.drop:main'")
    write("cpp", build_type="ament_cmake", **{"CMakeLists.txt": _CMAKE})
    for name in (
        "talker.py",
        "a.launch.py",
        "a.launch.xml",
        "notes.txt",
        "drive.cpp",
        "more/own.py",
    ):
        Path(name).parent.mkdir(exist_ok=True)
        Path(name).touch()


@pytest.mark.parametrize(
    ("words", "sentence", "hint"),
    [
        ("tlaker.py", "File 'tlaker.py' not found", "did you mean 'talker.py'?"),
        ("./Talker.py", "File './Talker.py' not found", "did you mean 'talker.py'?"),
        ("./talker", "File './talker' not found", "did you mean 'talker.py'?"),
        ("lessons/talker.py", "File 'lessons/talker.py' not found", "did you mean 'talker.py'?"),
        ("moer/own.py", "File 'moer/own.py' not found", "did you mean 'more/own.py'?"),
        ("robot/drive", "File 'robot/drive' not found", "are two words: zbot run robot drive"),
        ("robot.drive", "'robot.drive' is not a program", "two words: zbot run robot drive"),
        ("robot:drive", "'robot:drive' is not a program", "two words: zbot run robot drive"),
        ("robot drive.py", "No executable found", "did you mean 'drive'?"),
        ("robot dirve", "No executable found", "did you mean 'drive'?"),
        ("arm drop", "No executable found", "put a comma between the entry points in setup.py"),
        ("robto drive", "Package 'robto' not found", "did you mean 'robot'?"),
        ("robot_bringup drive", "Package 'robot_bringup' not found", "lists the packages"),
        ("cpp dirve", "No executable found", "C++, which zbot does not run: drive"),
        ("notes.txt/x", "File 'notes.txt/x' not found", ""),
        ("./notes.txt", "'./notes.txt' is not a Python program", ""),
        ("./drive.cpp", "'./drive.cpp' is not a Python program", "C++ needs ROS 2"),
        ("more", "'more' is a folder, not a program", "e.g. zbot run more/own.py"),
        ("src/robot", "'src/robot' is a folder, not a program", "zbot run robot PROGRAM"),
        (".", "'.' is a folder, not a program", "e.g. zbot run a.launch.py"),
        ("./a.launch.xml", "'./a.launch.xml' is a launch file", "type: zbot launch ./a.launch.xml"),
        ("robot a.launch.xml", "is a launch file", "type: zbot launch robot a.launch.xml"),
        ("notes", "No executable found", "`zbot pkg executables` lists the nodes"),
    ],
)
@pytest.mark.usefixtures("files")
def test_a_mistake_says_what_to_type(
    zbot_command: Command, words: str, sentence: str, hint: str
) -> None:
    refused = zbot_command("run", *words.split())
    assert (refused.code, refused.out) == (1, "")
    assert sentence in refused.err
    assert hint in refused.err
    assert bool(hint) is ("hint: " in refused.err)


@pytest.mark.parametrize(
    ("end", "hint"),
    [
        ("if __name__ == 'main':\n    main()", "write `if __name__ == '__main__':`, not 'main'"),
        ("if __name__ == '__main':\n    main()", "`if __name__ == '__main__':`, not '__main'"),
        ("if '__name__' == '__main__':\n    main()", "with __name__ not in quotes"),
        ("if __name__ == '__main__':\n    main", "write main(), with brackets"),
        ("main", "write main(), with brackets"),
    ],
)
def test_a_main_part_that_starts_nothing_is_an_error(tmp_path: Path, end: str, hint: str) -> None:
    path = tmp_path / "program.py"
    path.write_text(f"def main():\n    raise AssertionError\n\n{end}\n")
    with pytest.raises(NothingToRunError, match="has nothing to run") as caught:
        run_script(str(path))
    assert hint in caught.value.hint


def test_a_launch_file_is_started_with_launch(tmp_path: Path) -> None:
    path = tmp_path / "a.launch.py"
    path.write_text("def generate_launch_description():\n    return None\n")
    with pytest.raises(NothingToRunError, match="it is a launch file") as caught:
        run_script(str(path))
    assert caught.value.hint == f"type: zbot launch {path}"
