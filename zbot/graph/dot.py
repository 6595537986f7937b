"""Drawing of the graph in DOT, Graphviz's language."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.graph.topics import BoxKind
from zbot.graph.view import node_key

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.graph.view import Edge, GraphView

_HEAD = """digraph graph_of_nodes {
  rankdir=LR;
  node [fontname="sans-serif"];
  edge [fontname="sans-serif"];"""


def dot(drawn: GraphView) -> str:
    """Return a view in DOT. Nodes are ellipses, topics are boxes, and namespaces are clusters."""
    statements = {node_key(name): (name, _node(name)) for name in drawn.nodes}
    for box in drawn.boxes:
        shape = "box" if box.kind is BoxKind.TOPIC else "box3d"
        colour = ", color=red, fontcolor=red" if box.problem else ""
        text = f"{_quoted(box.key)} [label={_quoted(box.name)}, shape={shape}{colour}];"
        statements[box.key] = (box.name, text)
    framed = [(drawn.frames_of(name), text) for name, text in statements.values()]
    return "\n".join([_HEAD, *_frames(framed, 0), *map(_edge, drawn.edges), "}"])


def _node(name: str) -> str:
    return f"{_quoted(node_key(name))} [label={_quoted(name)}];"


def _frames(framed: list[tuple[tuple[str, ...], str]], depth: int) -> Iterator[str]:
    indent = "  " * (depth + 1)
    for path, text in framed:
        if len(path) == depth:
            yield indent + text
    for name in dict.fromkeys(path[depth] for path, _ in framed if len(path) > depth):
        inside = [(path, text) for path, text in framed if path[depth : depth + 1] == (name,)]
        yield f"{indent}subgraph {_quoted('cluster_' + name)} {{"
        yield f"{indent}  label={_quoted(name)};"
        yield from _frames(inside, depth + 1)
        yield f"{indent}}}"


def _edge(edge: Edge) -> str:
    attributes = [f"label={_quoted(edge.label)}"] if edge.label else []
    attributes += ["dir=both"] if edge.is_both_ways else []
    attributes += ["color=red"] if edge.is_wrong else []
    text = f" [{', '.join(attributes)}]" if attributes else ""
    return f"  {_quoted(edge.start_key)} -> {_quoted(edge.end_key)}{text};"


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
