"""Tests of `zbot param` with running nodes; most sentences are those of ros2."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

import zbot as library
from tests.cli.command import zbot
from tests.cli.param.conftest import SERVICE
from zbot_cli.domain.client import hidden_node

if TYPE_CHECKING:
    from tests.cli.conftest import Command
    from tests.conftest import MakeContext, Start


# -- as in ros2 ------------------------------------------------------------------------------------


@pytest.mark.usefixtures("node")
@pytest.mark.parametrize(
    ("words", "out"),
    [
        (
            ["list"],
            (
                "/minimal_service:\n  my_parameter\n  rate\n  start_type_description_service\n"
                "  use_sim_time\n"
            ),
        ),
        (
            ["list", "/minimal_service"],
            "  my_parameter\n  rate\n  start_type_description_service\n  use_sim_time\n",
        ),
        (["get", SERVICE, "my_parameter"], "String value is: world\n"),
        (["get", SERVICE, "rate"], "Double value is: 2.5\n"),
        (["get", SERVICE, "rate", "--hide-type"], "2.5\n"),
        (["set", SERVICE, "my_parameter", "earth"], "Set parameter successful\n"),
        (["describe", SERVICE, "rate"], "Parameter name: rate\n  Type: double\n  Constraints:\n"),
        (
            ["dump", SERVICE],
            (
                "/minimal_service:\n  ros__parameters:\n    my_parameter: world\n    rate: 2.5\n"
                "    start_type_description_service: true\n    use_sim_time: false\n\n"
            ),
        ),
    ],
)
def test_output_is_that_of_ros2(zbot_command: Command, words: list[str], out: str) -> None:
    result = zbot_command("param", *words)
    assert (result.code, result.out, result.err) == (0, out, "")


@pytest.mark.usefixtures("node")
@pytest.mark.parametrize(
    ("words", "err"),
    [
        (
            ["set", SERVICE, "rate", "hello"],
            (
                "Setting parameter failed: Wrong parameter type, expected 'double' got 'string': "
                "rate takes a value of type double, and is 2.5\n"
            ),
        ),
        (
            ["set", SERVICE, "nope", "1"],
            "Setting parameter failed: Invalid access to undeclared parameter(s): 'nope'\n",
        ),
        (
            ["set", SERVICE, "my_parameter", "5"],
            (
                "Setting parameter failed: Wrong parameter type, expected 'string' got 'integer': "
                "my_parameter takes a value of type string, and is 'world'\n\n"
                "hint: put a text that looks like a number into two kinds of quotes: \"'5'\"\n"
            ),
        ),
        (
            ["delete", SERVICE, "my_parameter"],
            "Deleting parameter failed: Static parameter cannot be undeclared\n",
        ),
        (
            ["get", SERVICE, "my_paramter"],
            (
                "Parameter not set\n\n"
                "hint: /minimal_service has no parameter my_paramter; "
                "did you mean 'my_parameter'?\n"
            ),
        ),
        (
            ["describe", SERVICE, "rat"],
            (
                "Parameter not set\n\n"
                "hint: /minimal_service has no parameter rat; did you mean 'rate'?\n"
            ),
        ),
        (
            ["get", "/minimal_servce", "rate", "--timeout", "0"],
            (
                "Node not found\n\n"
                "hint: no node /minimal_servce is running; did you mean '/minimal_service'?\n"
            ),
        ),
    ],
)
def test_a_refusal_is_one_sentence_and_exit_code_1(
    zbot_command: Command, words: list[str], err: str
) -> None:
    result = zbot_command("param", *words)
    assert (result.code, result.out, result.err) == (1, "", err)


def test_an_empty_domain_is_reported(zbot_command: Command, domain: int) -> None:  # noqa: ARG001 - empty
    result = zbot_command("param", "get", "robot", "rate", "--timeout", "0")
    assert (result.code, result.out) == (1, "")
    assert result.err == "Node not found\n\nhint: no node /robot is running; no node is running\n"
    assert "hint: no node is running\n" in zbot_command("param", "get", "rate").err
    assert zbot_command("param", "list").code == 0
    assert zbot_command("param", "dump").out == ""


def test_a_value_has_the_type_that_its_text_has(zbot_command: Command, node: library.Node) -> None:
    node.declare_parameter("gains", [1.0])
    assert zbot_command("param", "set", SERVICE, "rate", "-5").code == 0
    assert node.get_parameter("rate").value == -5.0
    assert zbot_command("param", "set", SERVICE, "my_parameter", "'5'").code == 0
    assert node.get_parameter("my_parameter").value == "5"
    assert zbot_command("param", "set", SERVICE, "gains", "[1, 2.5]").code == 0
    assert zbot_command("param", "get", SERVICE, "gains").out == "Double values are: [1.0, 2.5]\n"
    assert zbot_command("param", "set", SERVICE, "use_sim_time", "true").code == 0
    assert zbot_command("param", "get", SERVICE, "use_sim_time").out == "Boolean value is: True\n"


@pytest.mark.usefixtures("rich")
def test_values_of_every_type_are_shown(zbot_command: Command) -> None:
    names = ["level", "free", "port", "group.flags", "group.bytes", "group.words"]
    result = zbot_command("param", "get", "lab/rich", *names)
    assert result.out == (
        "level:\n  Integer value is: 50\n"
        "free:\n  Parameter not set.\n"
        "port:\n  Parameter not set.\n"
        "group.flags:\n  Boolean values are: [True, False]\n"
        "group.bytes:\n  Byte values are: [b'\\x01', b'\\xff']\n"
        "group.words:\n  String values are: ['a', \"it's\", '1e3', 'true', '']\n"
    )


@pytest.mark.usefixtures("rich")
def test_descriptions_show_every_declared_property(zbot_command: Command) -> None:
    result = zbot_command("param", "describe", "/lab/rich", "level", "share", "port")
    assert result.out == (
        "Parameter name: level\n  Type: integer\n  Description: How much\n  Constraints:\n"
        "    Min value: 0\n    Max value: 255\n    Step: 5\n"
        "    Additional constraints: even on Sundays\n"
        "Parameter name: share\n  Type: double\n  Constraints:\n    Read only: true\n"
        "    Min value: 0.0\n    Max value: 1.0\n    Step: 0.25\n"
        "Parameter name: port\n  Type: integer\n  Constraints:\n"
    )
    described = json.loads(zbot_command("param", "describe", "level", "--json").out)
    assert described == {
        "/lab/rich": [
            {
                "name": "level",
                "type": "integer",
                "description": "How much",
                "additional_constraints": "even on Sundays",
                "read_only": False,
                "dynamic_typing": False,
                "min": 0,
                "max": 255,
                "step": 5,
            }
        ]
    }


@pytest.mark.usefixtures("rich")
def test_a_list_can_be_filtered(zbot_command: Command) -> None:
    result = zbot_command("param", "list", "/lab/rich", "--param-prefixes", "group")
    assert result.out.split() == [
        "group",
        "group.bytes",
        "group.flags",
        "group.gains",
        "group.numbers",
        "group.words",
    ]
    result = zbot_command("param", "list", "--filter", "s", "--param-type")
    assert result.out == (
        "/lab/rich:\n  share (type: double)\n  start_type_description_service (type: boolean)\n"
    )
    assert zbot_command("param", "list", "--filter", "nothing").out == ""
    result = zbot_command("param", "list", "--filter", "(")
    assert (result.code, result.out) == (1, "")
    assert "--filter is not a regular expression" in result.err


# -- what ros2 does not do -------------------------------------------------------------------------


@pytest.mark.usefixtures("node", "rich")
def test_a_command_without_a_node_asks_every_node(zbot_command: Command) -> None:
    result = zbot_command("param", "get", "use_sim_time")
    assert result.out == (
        "/lab/rich:\n  Boolean value is: False\n/minimal_service:\n  Boolean value is: False\n"
    )
    assert json.loads(zbot_command("param", "get", "rate", "--json").out) == {
        "/minimal_service": {"rate": 2.5}
    }
    result = zbot_command("param", "set", "rate", "7", "my_parameter", "x")
    assert result.out == (
        "/minimal_service:\n  rate: Set parameter successful\n"
        "  my_parameter: Set parameter successful\n"
    )
    result = zbot_command("param", "delete", "level")
    assert (result.code, result.out) == (1, "/lab/rich:\n")
    result = zbot_command("param", "get", "ratte")
    assert result.err.startswith("Parameter 'ratte' not set on any node\n")
    assert result.err.endswith("hint: no node has a parameter ratte; did you mean 'rate'?\n")
    dumped = json.loads(zbot_command("param", "dump", "--json").out)
    assert sorted(dumped) == ["/lab/rich", "/minimal_service"]
    assert dumped["/lab/rich"]["group.bytes"] == [1, 255]


def test_several_parameters_are_set_one_by_one_or_atomically(
    zbot_command: Command, node: library.Node
) -> None:
    words = ["param", "set", SERVICE, "rate", "9", "my_parameter", "9"]
    result = zbot_command(*words, "--atomic")
    assert (result.code, result.out) == (1, "")
    assert result.err.startswith("Setting parameters atomically failed: Wrong parameter type")
    assert node.get_parameter("rate").value == 2.5
    result = zbot_command(*words[:-1], "text", "--atomic")
    assert (result.code, result.out) == (0, "Set parameters atomically successful\n")
    result = zbot_command(*words)
    assert result.out == "rate: Set parameter successful\n"
    assert result.err.startswith("my_parameter: Setting parameter failed: Wrong parameter type")
    assert node.get_parameter("rate").value == 9.0


def test_a_parameter_without_a_value_is_refused(zbot_command: Command) -> None:
    result = zbot_command("param", "set", "/lab/rich", "rate", "9", "my_parameter")
    assert result.code == 2
    assert "give each name a value: my_parameter has none" in result.err
    result = zbot_command("param", "set", "/lab/rich", "rate=9")
    assert result.code == 2
    assert "write a blank, not '=': zbot param set /lab/rich rate 9" in result.err


@pytest.mark.usefixtures("rich")
@pytest.mark.parametrize(
    ("words", "advice"),
    [
        (("set", "minimal_service", "rate"), "zbot param set minimal_service rate VALUE"),
        (("get", "minimal_service"), "zbot param get minimal_service PARAM"),
        (("describe", "/minimal_service"), "zbot param describe /minimal_service PARAM"),
        (("delete", "lab/rich"), "zbot param delete lab/rich PARAM"),
    ],
)
def test_a_forgotten_last_word_is_named(
    zbot_command: Command, node: library.Node, words: tuple[str, ...], advice: str
) -> None:
    del node
    result = zbot_command("param", *words)
    assert (result.code, result.out) == (1, "")
    assert f" is a node: type: {advice}\n" in result.err


def test_a_forgotten_file_is_named(zbot_command: Command) -> None:
    result = zbot_command("param", "load", "turtlesim")
    assert (result.code, result.out) == (1, "")
    assert "hint: name a file: zbot param load turtlesim FILE.yaml\n" in result.err


def test_a_dynamic_parameter_is_deleted(zbot_command: Command, rich: library.Node) -> None:
    assert zbot_command("param", "set", "/lab/rich", "free", "1").code == 0
    result = zbot_command("param", "delete", "/lab/rich", "free")
    assert (result.code, result.out) == (0, "Deleted parameter successfully\n")
    assert not rich.has_parameter("free")


@pytest.mark.parametrize(
    "words",
    [
        ["get"],
        ["set", "rate"],
        ["set", SERVICE, "rate", "5", "--atomc"],
        ["load", "a", "b", "c"],
        ["delete"],
    ],
)
def test_an_invalid_command_line_is_refused(zbot_command: Command, words: list[str]) -> None:
    assert zbot_command("param", *words).code == 2


# -- with real processes ---------------------------------------------------------------------------


def test_the_bundled_parameter_demo_accepts_and_refuses_values(start: Start) -> None:
    demo = start("zbot", "run", "parameter_demo", "--ros-args", "-p", "speed:=1")
    demo.wait_for("Ada drives 1.00 m/s: 3.2 turns a second")
    assert zbot("param", "set", "parameter_demo", "speed", "2").out == "Set parameter successful\n"
    demo.wait_for("speed is now 2.0")
    demo.wait_for("Ada drives 2.00 m/s")
    refused = zbot("param", "set", "/parameter_demo", "speed", "3")
    assert (refused.code, refused.err) == (
        1,
        (
            "Setting parameter failed: Parameter speed out of range. Min: 0.0, Max: 2.0, "
            "value: 3.0 (double, now 2.0)\n"
        ),
    )
    assert "a driver needs a name" in zbot("param", "set", "/parameter_demo", "driver", "''").err
    demo.stop()
    assert "Traceback" not in demo.output


def test_the_parameter_blackboard_accepts_any_parameter(start: Start) -> None:
    arguments = ("--ros-args", "-p", "colour:=green")
    start("zbot", "run", "demo_nodes_cpp", "parameter_blackboard", *arguments).wait_for("already")
    assert zbot("param", "set", "parameter_blackboard", "size", "3").out == (
        "Set parameter successful\n"
    )
    assert zbot("param", "get", "parameter_blackboard", "size").out == "Integer value is: 3\n"
    assert zbot("param", "get", "parameter_blackboard", "colour").out == "String value is: green\n"


def test_a_node_that_does_not_spin_is_named(
    zbot_command: Command, make_context: MakeContext
) -> None:
    soon = ("--service-timeout", "0.2")
    nodes = [
        library.Node("asleep", context=make_context()),
        library.Node("closed", context=make_context(), start_parameter_services=False),
    ]
    result = zbot_command("param", "list", *soon)
    assert (result.code, result.out) == (1, "")
    assert result.err == (
        "Wait for service timed out waiting for parameter services for node /asleep\n"
    )
    result = zbot_command("param", "list", "/asleep", *soon)
    assert "/asleep does not answer: does it spin?" in result.err
    result = zbot_command("param", "get", "/closed", "x")
    assert result.err == (
        "Wait for service timed out waiting for parameter services for node /closed\n\n"
        "hint: /closed has no /closed/get_parameters\n"
    )
    assert len(nodes) == 2


@pytest.mark.usefixtures("node", "rich")
def test_a_command_with_its_own_node_sees_all_nodes_at_once() -> None:
    for _ in range(20):
        with hidden_node("test") as hidden:
            names = hidden.get_fully_qualified_node_names()
            assert {"/lab/rich", "/minimal_service"} <= set(names)


@pytest.mark.usefixtures("node")
def test_tab_completes_nodes_and_parameters(zbot_command: Command) -> None:
    assert zbot_command("complete", "--", "param", "get", "/m").out == "/minimal_service\n"
    words = ["complete", "--", "param", "set", SERVICE]
    assert zbot_command(*words, "r").out == "rate\n"
    assert zbot_command(*words, "rate", "").out == ""
    assert zbot_command(*words, "rate", "1", "m").out == "my_parameter\n"
    assert zbot_command("complete", "--", "param", "get", "/nobody", "").out == ""
