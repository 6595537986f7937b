"""The reference is complete: commands, variables, exit codes, Python names."""

from __future__ import annotations

import importlib
import inspect
import re
from pathlib import Path

import pytest

from docs.generator import api, commands
from zbot_cli.output.exit_status import Status

ROOT = Path(__file__).parents[2]
REFERENCE = ROOT / "docs" / "reference"
VARIABLE = re.compile(
    r"\"(?:(?:ZBOT|ROS|RCUTILS|ZENOH|AMENT|COLCON|XDG|GZ|IGN|GAZEBO|SDF)_[A-Z0-9_]+|RMW_IMPLEMENTATION|[A-Z]+_COLOR)\""
)
#: Names that only look like variables of the environment.
OTHERS = {
    "ZBOT_COMMAND_DOMAIN",  # between processes of one command
    "AMENT_IGNORE",  # files
    "COLCON_IGNORE",
    "AMENT_CMAKE",
    "AMENT_PYTHON",
    "AMENT_PREFIX_PATH_ENV_VAR",  # constants
    "GZ_TO_ROS",
    "ROS_TO_GZ",
    "ROS_TIME",
    "ZBOT_CDR_CAPACITY",  # macros of C
    "ZBOT_CDR_TEXT_CAPACITY",
    "ROS_TIME_NO_CHANGE",
    "ROS_TIME_ACTIVATED",
    "ROS_TIME_DEACTIVATED",
}


def sources() -> list[Path]:
    folders = ("zbot", "cli", "nodes", "launch")
    return [path for folder in folders for path in (ROOT / folder).glob("**/*.py")]


def test_the_page_of_the_commands_is_that_of_the_code() -> None:
    written = (REFERENCE / "commands.md").read_text(encoding="utf-8")
    assert written == commands.page(), "type `python -m docs.generator`"


def test_every_variable_is_on_the_page() -> None:
    text = "\n".join(path.read_text(encoding="utf-8") for path in sources())
    used = {found.strip('"') for found in VARIABLE.findall(text)} - OTHERS
    page = (REFERENCE / "environment.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\|([^|]+)\|", page, re.MULTILINE)
    assert {name for row in rows for name in re.findall(r"`([A-Z]+_[A-Z0-9_]+)`", row)} == used


def test_every_exit_code_is_on_the_page() -> None:
    page = (REFERENCE / "exit-codes.md").read_text(encoding="utf-8")
    assert [int(code) for code in re.findall(r"^\| (\d+) \|", page, re.MULTILINE)] == list(Status)


@pytest.mark.parametrize("package", api.PACKAGES)
def test_every_public_name_has_a_text(package: str) -> None:
    module = importlib.import_module(package)
    names = api.public_names(module)
    assert re.findall(r"^## (\w+)$", api.page(package), re.MULTILINE) == names != []
    classes = {name for name in names if inspect.isclass(getattr(module, name))}
    assert not {name for name in classes if not inspect.getdoc(getattr(module, name))}
