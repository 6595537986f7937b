"""Launch files in the styles of public courses, launched as they are."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import pytest

from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program

    Start = Callable[..., Program]

FILES = Path(__file__).parent / "launch"


class Case(NamedTuple):
    """A launch file, what it has to print in any order, and how its launch is to go."""

    file: str
    lines: tuple[str, ...]
    words: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()  #: what `zbot node list` shows meanwhile


CASES = [
    Case("talker_listener.launch.py", ("[talker-1]", "I heard: [Hello World: ")),
    Case(
        "demo_packages.launch.yaml",
        ("I heard: [Hello World: ", "Result of add_two_ints: for 2 + 3 = 5"),
        nodes=(
            "/py/listener",
            "/py/talker",
            "/service_node",
            "/xml/listener",
            "/xml/talker",
            "/yaml/listener",
            "/yaml/talker",
        ),
    ),
    Case(
        "multisim.launch.py",
        ("Spawning turtle [turtle1]", "Spawning turtle [turtle1]"),
        nodes=("/turtlesim1/turtlesim", "/turtlesim2/turtlesim"),
    ),
    Case(
        "turtlesim_mimic.launch.py",
        ("[mimic-3]: process started with pid",),
        nodes=("/mimic", "/turtlesim1/sim", "/turtlesim2/sim"),
    ),
    Case(
        "turtlesim_mimic.launch.xml",
        ("[mimic-3]: process started with pid",),
        nodes=("/mimic", "/turtlesim1/sim", "/turtlesim2/sim"),
    ),
    Case(
        "turtlesim_mimic.launch.yaml",
        ("[mimic-2]: process started with pid",),
        nodes=("/mimic", "/turtlesim1/sim"),
    ),
    Case("arguments.launch.py", ("the speed is 1.0", "[talker-1]"), nodes=("/talker",)),
    Case("arguments.launch.py", ("the speed is 2", "fast", "silence"), ("speed:=2", "talk:=false")),
    Case("parameters.launch.py", ("Grace drives 1.25 m/s",), nodes=("/demo",)),
    Case(
        "include_group.launch.py",
        ("the speed is 2.0", "fast", "I heard: [Hello World: "),
        nodes=("/robot1/listener", "/robot1/talker", "/robot2/talker"),
    ),
    Case(
        "events.launch.py",
        (
            "Turtlesim started",
            "Spawn request says",
            "Spawn finished",
            "process has finished cleanly",
        ),
    ),
    Case("static_tf.launch.py", ("- Translation: [0.000, 0.000, 0.200]",)),
    Case("opaque.launch.py", ("2 talkers", "[talker-2]"), nodes=("/talker_0", "/talker_1")),
    Case("respawn.launch.py", ("once is over", "] again", "] again", "] again")),
    Case("lifecycle.launch.py", ("the talker is configured",)),
    Case(
        "arguments.launch.xml",
        ("an executable", "hello from other", "[talker-1]"),
        ("name:=other",),
        nodes=("/from_xml/other",),
    ),
    Case(
        "include.launch.yaml",
        ("hello from inner",),
        nodes=("/from_xml/inner", "/yaml_space/ear"),
    ),
]


def test_every_launch_file_of_the_survey_is_in_the_table() -> None:
    assert {path.name for path in FILES.glob("*.launch.*")} == {case.file for case in CASES}


@pytest.mark.parametrize("case", CASES, ids=[f"{case.file}-{len(case.words)}" for case in CASES])
def test_it_is_launched_as_it_is(case: Case, start: Start, tmp_path: Path) -> None:
    files = {"TMPDIR": str(tmp_path)}  # one leaves a file there, as its author wrote it
    launch = start("zbot", "launch", str(FILES / case.file), *case.words, env=files)
    for line in case.lines:
        if not any(line in seen for seen in launch.lines) or case.lines.count(line) > 1:
            launch.wait_for(line, 20)
    if case.nodes:
        wanted = "\n".join(case.nodes)
        seen = ""

        def is_complete() -> bool:
            nonlocal seen
            listing = start("zbot", "node", "list")
            listing.wait()
            seen = listing.output
            return seen == wanted

        assert wait_until(is_complete, 20), seen
    launch.stop(timeout_s=15)
    assert "Traceback" not in launch.output
