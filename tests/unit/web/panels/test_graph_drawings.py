"""Tests of the drawings of the graph that pages share."""

from __future__ import annotations

from dataclasses import replace

from zbot.graph.snapshot import Snapshot
from zbot.graph.view import Mode
from zbot.web.panels.graph.graph_drawings import GraphDrawings
from zbot.web.panels.graph.graph_options import GraphOptions
from zbot.wire.tokens import NodeToken

OPTIONS = GraphOptions()


class Graph:
    """Graph of a system, which changes when `now` is set."""

    def __init__(self) -> None:
        self.now = graph("a", "b")

    def __call__(self) -> Snapshot:
        return self.now


def graph(*names: str) -> Snapshot:
    return Snapshot(
        tuple(
            NodeToken(domain=0, zid="a", nid=number, namespace="/", node=name)
            for number, name in enumerate(names)
        )
    )


def test_pages_with_the_same_options_share_a_drawing() -> None:
    now = Graph()
    drawings = GraphDrawings(now)
    one = drawings.draw(OPTIONS, None)
    assert drawings.draw(OPTIONS, None) is one
    now.now = graph("a", "b", "c")
    other = drawings.draw(OPTIONS, one)
    assert other is not one
    assert "/c" in other.svg
    assert drawings.draw(OPTIONS, one) is other


def test_a_graph_that_looks_the_same_is_not_drawn_again() -> None:
    now = Graph()
    drawings = GraphDrawings(now)
    one = drawings.draw(OPTIONS, None)
    now.now = graph("b", "a")
    assert drawings.draw(OPTIONS, one).drawing is one.drawing


def test_other_options_have_another_drawing() -> None:
    drawings = GraphDrawings(Graph())
    one = drawings.draw(OPTIONS, None)
    other = drawings.draw(replace(OPTIONS, mode=Mode.NODES), one)
    assert other.view.mode is Mode.NODES
    assert drawings.draw(OPTIONS, other) is one


def test_a_page_with_its_own_layout_changes_no_other_page() -> None:
    drawings = GraphDrawings(Graph())
    one = drawings.draw(OPTIONS, None)
    own = drawings.draw(OPTIONS, None, is_shared=False)
    assert own.drawing is not one.drawing
    assert drawings.draw(OPTIONS, None) is one
