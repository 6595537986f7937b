"""Tests of the graph's picture as SVG and of its DOT text for Graphviz."""

from __future__ import annotations

import time
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.unit.graph.test_view import TALKING, node, publishes, subscribes
from zbot.graph.diagram import draw, lines_of
from zbot.graph.snapshot import Snapshot, Token
from zbot.graph.style import style, text_width
from zbot.graph.view import Grouping, Mode, view

SVG = "{http://www.w3.org/2000/svg}"
NODES, TOPICS = ("a", "b", "c", "d"), ("/x", "/r/y", "/r/s/z", "/r/s/w")


@st.composite
def snapshots(draw: st.DrawFn) -> Snapshot:
    pairs = st.lists(st.tuples(st.sampled_from(NODES), st.sampled_from(TOPICS)), max_size=10)
    names = draw(st.sets(st.sampled_from(NODES)))
    tokens = [node(name) for name in sorted(names)]
    talking = [publishes(name, topic) for name, topic in draw(pairs) if name in names]
    hearing = [subscribes(name, topic) for name, topic in draw(pairs) if name in names]
    return Snapshot((*tokens, *talking, *hearing))


def parsed(svg: str) -> ET.Element:
    return ET.fromstring(svg)


def keys(svg: str, of: str) -> list[str]:
    return [
        element.attrib["data-key"]
        for element in parsed(svg).iter(SVG + "g")
        if of in element.attrib["class"].split()
    ]


@settings(max_examples=60)
@given(snapshots(), st.sampled_from(Mode), st.integers(0, 2))
def test_each_node_topic_and_edge_is_drawn_once(
    snapshot: Snapshot, mode: Mode, namespaces: int
) -> None:
    shown = view(snapshot, mode, grouping=Grouping(namespaces))
    svg = draw(shown).svg()
    assert keys(svg, "node") == [f"n:{name}" for name in shown.nodes]
    assert keys(svg, "topic") == [box.key for box in shown.boxes]
    assert len(set(keys(svg, "edge"))) == len(shown.edges)
    frames = {frame for name in shown.nodes for frame in shown.frames_of(name)}
    frames |= {frame for box in shown.boxes for frame in shown.frames_of(box.name)}
    assert {key[2:].partition("#")[0] for key in keys(svg, "frame")} == frames
    assert draw(shown).svg() == svg


def test_names_are_text() -> None:
    root = parsed(draw(view(TALKING)).svg())
    texts = ["".join(element.itertext()) for element in root.iter(SVG + "text")]
    assert texts == ["/listener", "/talker", "/chatter", "/count"]


def test_names_from_other_programs_are_escaped() -> None:
    evil = '<script>alert("1")</script>&\'x'
    tokens = (node(evil), publishes(evil, "/" + evil, evil), subscribes(evil, "/" + evil, "y"))
    for mode in Mode:
        root = parsed(draw(view(Snapshot(tokens), mode)).svg())
        assert not [element for element in root.iter() if "script" in element.tag]
        shown = [
            element.get("data-node") for element in root.iter(SVG + "g") if element.get("data-node")
        ]
        assert shown == ["/" + evil]


def test_long_names_take_two_lines() -> None:
    name = "/warehouse/robot_12/front_camera/image_rectified"
    assert lines_of(name) == ["/warehouse/robot_12", "/front_camera/image_rectified"]
    assert lines_of("/short") == ["/short"]
    assert lines_of("/" + "x" * 80) == ["/" + "x" * 80]


def test_problems_are_red_and_in_the_title() -> None:
    tokens = (*TALKING.tokens, node("lost"), subscribes("lost", "/chater"))
    root = parsed(draw(view(Snapshot(tokens))).svg())
    [wrong] = [
        element for element in root.iter(SVG + "g") if element.get("class") == "item topic wrong"
    ]
    assert wrong.attrib["data-topic"] == "/chater"
    assert "did you mean '/chatter'?" in (wrong.findtext(SVG + "title") or "")
    assert [key for key in keys(draw(view(Snapshot(tokens))).svg(), "wrong") if key[0] == "e"] == [
        "e:t:/chater>n:/lost#"
    ]


def test_only_edges_without_messages_are_red() -> None:
    tokens = (*TALKING.tokens, node("lost"), subscribes("lost", "/chatter", "std_msgs/msg/Int32"))
    drawn = view(Snapshot(tokens))
    wrong = [edge for edge in drawn.edges if edge.is_wrong]
    assert [(edge.start, edge.end) for edge in wrong] == [("/chatter", "/lost")]
    wrong = [edge for edge in view(Snapshot(tokens), Mode.NODES).edges if edge.is_wrong]
    assert [(edge.start, edge.end) for edge in wrong] == [("/talker", "/lost")]


def test_labels_are_beside_edges() -> None:
    drawing = draw(view(TALKING))
    edge = drawing.view.edges[0]
    assert ">9.9 Hz</text>" in drawing.svg({edge: "9.9 Hz"})
    assert "Hz" not in drawing.svg()


def test_a_new_node_does_not_move_the_others() -> None:
    before = draw(view(TALKING))
    tokens = (*TALKING.tokens, node("late"), subscribes("late", "/chatter"))
    after = draw(view(Snapshot(tokens)), before)
    for key, place in before.layout.places.items():
        assert after.layout.places[key].x == pytest.approx(place.x)
        assert after.layout.places[key].y == pytest.approx(place.y, abs=1.0)


def test_other_frames_cause_a_new_layout() -> None:
    tokens = (node("a"), publishes("a", "/robot/scan"), publishes("a", "/robot/odom"))
    framed = draw(view(Snapshot(tokens)))
    plain = draw(view(Snapshot(tokens), grouping=Grouping(namespaces=0)), framed)
    assert plain.layout == draw(plain.view).layout
    assert not plain.layout.frames


def test_an_empty_graph_has_a_text() -> None:
    assert "no node is running" in draw(view(Snapshot(()))).svg()


def test_the_style_has_light_and_dark_colours() -> None:
    assert "prefers-color-scheme: dark" in style()
    assert "var(" not in style()  # programs that show SVG files know no variables


def test_text_has_about_the_width_of_its_letters() -> None:
    assert text_width("/chatter", 15) < text_width("/mmmmmmm", 15)
    assert 50 < text_width("/chatter", 15) < 62  # 54.2 in Liberation Sans


def crowd(nodes: int = 50, topics: int = 150) -> Snapshot:
    tokens: list[Token] = [node(f"node_{number}") for number in range(nodes)]
    for number in range(topics):
        start = number % nodes
        topic = f"/part_{start % 7}/topic_{number}"
        ends = {(start + 1 + number // nodes) % nodes, (start * 7 + number) % nodes}
        tokens.append(publishes(f"node_{start}", topic))
        tokens += [subscribes(f"node_{end}", topic) for end in sorted(ends)]
    return Snapshot(tuple(tokens))


def test_a_large_graph_is_drawn_quickly() -> None:
    begin = time.process_time()
    drawing = draw(view(crowd()))
    drawing.svg()
    assert time.process_time() - begin < 2.0  # also on a busy machine
    assert len(drawing.layout.places) == 200
