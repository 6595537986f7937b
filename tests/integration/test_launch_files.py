"""Launch files in Python, XML and YAML, and the nodes and lines that each gives."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import pytest

import zbot
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Start

FILES = Path(__file__).parents[1] / "programs" / "launch"
MIMIC, POSE = ("[mimic-3]: process started",), "/north/turtle1/pose"
PONDS = ("/north/water", "/south/water")
PIER = (
    *("/echo", "/py/listener", "/py/talker", "/service_node", "/survey"),
    *("/xml/listener", "/xml/talker", "/yaml/listener", "/yaml/talker"),
)


class Case(NamedTuple):
    """A launch file, the lines that it has to print in any order, and the nodes that run then."""

    file: str
    lines: tuple[str, ...]
    nodes: tuple[str, ...] = ()  #: their full names, without hidden ones
    words: tuple[str, ...] = ()
    unwanted: str = "Traceback"  #: a text that it must not print
    heard: str = ""  #: a topic that one of the nodes subscribes to


CASES = [
    Case("ponds.launch.py", MIMIC, ("/ripple", *PONDS), heard=POSE),
    Case("ponds.launch.xml", MIMIC, ("/ripple", *PONDS), heard=POSE),
    Case("ponds.launch.yaml", (), PONDS, ("follow:=false",), "mimic"),
    Case(
        "orchard.launch.py",
        (
            "a garden of 2",
            "/shed /opened 1",
            "angles DOUBLE_ARRAY [0.25, 0.75]",
            "open_at DOUBLE 30.5",
            "panes INTEGER 2",
        ),
        ("/row_0", "/row_1"),
        ("rows:=2",),
        "an orchard",
    ),
    Case(
        "valley.launch.py",
        ("an orchard of 3", "a garden of 1", "/sunny/shed /sunny/opened", "/shady/shed"),
        ("/shady/row_0", "/sunny/row_0", "/sunny/row_1", "/sunny/row_2"),
    ),
    Case(
        "quay.launch.xml",
        (
            "lifting with new_hook at the quay",
            "- Translation: [0.000, 0.000, 4.500]",
            "I heard: ",
            "2 + 3 = 5",
        ),
        (*PIER[:3], "/quay/new_hook", *PIER[3:]),
        ("crane:=new",),
        "unwanted",
    ),
    Case("pier.launch.yaml", ("- Translation: [0.000, 0.000, 1.000]",), PIER),
]


def test_every_launch_file_is_launched() -> None:
    launched = {case.file for case in CASES} | {"alarm.launch.py"}
    assert {path.name for path in FILES.glob("*.launch.*")} == launched


@pytest.mark.parametrize("case", CASES, ids=[case.file for case in CASES])
def test_a_file_is_launched(
    case: Case, start: Start, make_context: Callable[[], zbot.Context]
) -> None:
    looker = zbot.Node("looker", context=make_context())
    launch = start("zbot", "launch", str(FILES / case.file), *case.words)
    for line in case.lines:
        if not any(line in seen for seen in launch.lines):
            launch.wait_for(line, 20)

    def nodes() -> list[str]:
        found = looker.get_node_names_and_namespaces()
        return sorted(f"{space.rstrip('/')}/{name}" for name, space in found if name != "looker")

    assert wait_until(lambda: nodes() == sorted(case.nodes), 10), nodes()
    if case.heard:
        assert wait_until(lambda: looker.count_subscribers(case.heard) == 1)
    assert launch.stop(timeout=15) == 0
    assert case.unwanted not in launch.output
    assert "Traceback" not in launch.output


def test_events_wake_the_guard(start: Start) -> None:
    launch = start("zbot", "launch", str(FILES / "alarm.launch.py"))
    assert launch.wait(20) == 0, launch.output
    said = [line.rpartition("]: ")[2] for line in launch.lines if "[launch.user]" in line]
    assert said == ["up", "the siren starts", "heard a wail"]
    assert sum(line.endswith("] asleep") for line in launch.lines) == 3
