"""Lines of the README can be typed in bash, PowerShell 5.1 and cmd."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from zbot_cli.main import NOUNS

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
PROSE = re.sub(r"```.*?```", "", TEXT, flags=re.DOTALL)
BLOCKS = [
    [line.strip() for line in block.strip("\n").split("\n")]
    for block in re.findall(r"(?:^    \S.*\n)+", PROSE, re.MULTILINE)
]
LINES = [line for block in BLOCKS for line in block]
#: Commands that run until Ctrl-C.
ENDLESS = ("zbot run", "zbot web", "zbot hub", "zbot launch", "zbot topic echo temperature")


def test_the_readme_has_blocks() -> None:
    assert len(BLOCKS) > 5


@pytest.mark.parametrize("line", LINES)
def test_a_line_works_in_every_shell(line: str) -> None:
    assert not set("'#;&|\\") & set(line)


@pytest.mark.parametrize("block", BLOCKS)
def test_only_the_last_line_of_a_block_may_run_for_ever(block: list[str]) -> None:
    assert not any(line.startswith(ENDLESS) for line in block[:-1])


@pytest.mark.parametrize("words", re.findall(r"(?:`|^    )zbot ([^`\n]+)", PROSE, re.MULTILINE))
def test_the_commands_exist(words: str) -> None:
    assert words.split(maxsplit=1)[0] in NOUNS


def test_the_test_command_is_that_of_the_checks() -> None:
    script = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    block = next(block for block in BLOCKS if block[-1].startswith("python -m pytest"))
    assert all(line in script for line in block)


def test_the_workflow_runs_the_test_commands_on_three_systems() -> None:
    text = (ROOT / ".github" / "workflows" / "checks.yml").read_text(encoding="utf-8")
    jobs = yaml.safe_load(text)["jobs"]
    assert ".ci/run" in [step.get("run") for step in jobs["all-checks"]["steps"]]
    block = next(block for block in BLOCKS if block[-1].startswith("python -m pytest"))
    assert [step["run"] for step in jobs["tests"]["steps"] if "run" in step] == block
    matrix = jobs["tests"]["strategy"]["matrix"]
    assert {name.partition("-")[0] for name in matrix["os"]} == {"ubuntu", "windows", "macos"}
    project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    supported = re.findall(r"Programming Language :: Python :: (3\.\d+)", project)
    assert matrix["python"] == supported
