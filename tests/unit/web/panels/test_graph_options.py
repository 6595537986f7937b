from __future__ import annotations

import shlex

import pytest

from tests.unit.graph.test_view import TALKING
from zbot.graph.filters import Filters, Grouping
from zbot.graph.view import Mode
from zbot.web.panels.graph.graph_options import FLAGS, GraphOptions, filter_problem
from zbot_cli.nouns import load


def test_default_options_need_no_query_and_no_command_options() -> None:
    assert GraphOptions().query == {}
    assert GraphOptions().command == "zbot graph"
    assert GraphOptions.from_query({}) == GraphOptions()


@pytest.mark.parametrize("flag", FLAGS)
def test_each_option_is_in_the_query(flag: str) -> None:
    options = GraphOptions().flagged(flag, is_set=True)
    assert options.has(flag)
    assert options.query == {flag: "1"}
    assert GraphOptions.from_query(options.query) == options
    assert options.flagged(flag, is_set=False) == GraphOptions()


def test_all_options_together_are_in_the_query() -> None:
    options = GraphOptions(
        Mode.ACTIVE,
        Filters(nodes="-/a.*", topics="/b, -/c", hidden=False),
        Grouping(namespaces=0, images=False),
    )
    assert GraphOptions.from_query(options.query) == options
    assert options.command == (
        "zbot graph --show active --nodes '-/a.*' --topics '/b, -/c' --group-namespaces 0"
        " --include-hidden --no-group-images"
    )


def test_unknown_query_parameters_are_ignored() -> None:
    query = {"show": "x", "nodes": "(", "group-namespaces": "-1", "unknown": "1"}
    assert GraphOptions.from_query(query) == GraphOptions()


def test_the_command_has_every_option() -> None:
    options = load("graph").params
    known = {name for option in options for name in (*option.opts, *option.secondary_opts)}
    assert {f"--{flag}" for flag in FLAGS} <= known
    everything = GraphOptions(Mode.NODES, Filters(nodes="/a", topics="/b"), Grouping(1))
    words = shlex.split(everything.command)
    assert {word for word in words if word.startswith("--")} <= known


def test_an_invalid_filter_has_a_problem() -> None:
    assert filter_problem(None) is None
    assert filter_problem("/a.*,-/b") is None
    assert "invalid filter '('" in (filter_problem("(") or "")


def test_view_is_the_same_as_of_the_command() -> None:
    options = GraphOptions.from_query({"show": "nodes", "nodes": "-/listener"})
    assert options.view(TALKING).nodes == ("/talker",)
