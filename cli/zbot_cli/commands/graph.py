"""`zbot graph`: prints the nodes and their connections, as text, JSON or a picture."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from zbot.errors import ExternalShutdownException
from zbot.graph.filters import Filters, Grouping, compile_filter
from zbot.graph.view import BoxKind, Edge, GraphView, Mode, TopicView, view
from zbot_cli.domain.client import client, snapshot
from zbot_cli.errors import CommandError
from zbot_cli.output.listing import AsJson, new_app, print_json

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.graph.diagram import Drawing
    from zbot.graph.snapshot import Snapshot

app = new_app("Show which nodes talk to each other", has_verbs=False)

_MAX_NAMESPACES = 9

_Filter = "names or regular expressions; to leave some out, put `-` before them"


def picture_error(path: str, reason: str) -> CommandError:
    """Return the error that the file of a picture cannot be written."""
    return CommandError(f"cannot write {path}: {reason}; choose a folder that exists")


@app.command()
def graph(
    mode: Annotated[Mode, typer.Option("--show", help="Which topics to show")] = Mode.ALL,
    nodes: Annotated[str, typer.Option("--nodes", help=f"Which nodes: {_Filter}")] = "/",
    topics: Annotated[str, typer.Option("--topics", help=f"Which topics: {_Filter}")] = "/",
    debug: Annotated[
        bool,
        typer.Option("--debug-topics", help="Show /rosout, /statistics, /clock, rqt, rviz too"),
    ] = False,
    params: Annotated[bool, typer.Option("--params", help="Show /parameter_events too")] = False,
    no_tf: Annotated[bool, typer.Option("--no-tf", help="Leave transforms out")] = False,
    no_dead_sinks: Annotated[
        bool, typer.Option("--no-dead-sinks", help="Leave out topics without subscriptions")
    ] = False,
    no_leaf_topics: Annotated[
        bool, typer.Option("--no-leaf-topics", help="Leave out topics with one connection")
    ] = False,
    no_actions: Annotated[bool, typer.Option("--no-actions", help="Leave actions out")] = False,
    include_hidden: Annotated[
        bool, typer.Option("--include-hidden", help="Show hidden names too")
    ] = False,
    namespaces: Annotated[
        int,
        typer.Option(
            "--group-namespaces",
            min=0,
            max=_MAX_NAMESPACES,
            help="Number of namespace levels that have frames in a picture",
        ),
    ] = 2,
    actions: Annotated[
        bool, typer.Option("--group-actions/--no-group-actions", help="Show an action as one box")
    ] = True,
    tf: Annotated[
        bool, typer.Option("--group-tf/--no-group-tf", help="Show /tf and /tf_static as one box")
    ] = True,
    images: Annotated[
        bool,
        typer.Option(
            "--group-images/--no-group-images",
            help="Show an image and its compressed forms as one box",
        ),
    ] = True,
    as_dot: Annotated[bool, typer.Option("--dot", help="Print DOT, for Graphviz")] = False,
    svg: Annotated[
        str, typer.Option("--svg", metavar="FILE", help="Write a picture; print it if FILE is -")
    ] = "",
    watch: Annotated[
        bool, typer.Option("--watch", help="Print or write the graph again at each change")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Show which nodes talk to each other."""
    filters = Filters(
        debug=not debug,
        tf=no_tf,
        params=not params,
        dead_sinks=no_dead_sinks,
        leaf_topics=no_leaf_topics,
        actions=no_actions,
        hidden=not include_hidden,
        nodes=nodes,
        topics=topics,
    )
    for text in (nodes, topics):
        compile_filter(text)  # reports an invalid filter before the command waits for nodes
    grouping = Grouping(namespaces, actions, tf, images)

    def make_view(seen: Snapshot) -> GraphView:
        return view(seen, mode, filters, grouping)

    show = _Output(svg, as_dot=as_dot, as_json=as_json)
    if watch:
        _watch(make_view, show)
    else:
        show(make_view(snapshot()))


class _Output:
    """Writer of views of the graph, in the form that the options select."""

    def __init__(self, svg: str, *, as_dot: bool, as_json: bool) -> None:
        self._svg, self._as_dot, self._as_json = svg, as_dot, as_json
        self._drawing: Drawing | None = None

    @property
    def separates_by_blank_line(self) -> bool:
        """Whether an empty line separates one view from the next."""
        return not (self._svg or self._as_json)

    def __call__(self, drawn: GraphView) -> None:
        if self._svg:
            self._draw(drawn)
        elif self._as_json:
            print_json(_document(drawn))
        else:
            print(_dot(drawn) if self._as_dot else _text(drawn), flush=True)

    def _draw(self, drawn: GraphView) -> None:
        from zbot.graph.diagram import draw  # noqa: PLC0415 - not needed for text

        self._drawing = draw(drawn, self._drawing)
        if self._svg == "-":
            print(self._drawing.svg(), end="", flush=True)
        else:
            _write(self._svg, self._drawing.svg())
            print(f"wrote {self._svg}", file=sys.stderr)


def _write(path: str, text: str) -> None:
    """Replace a file in one step, so that a viewer never reads half a picture."""
    target = Path(path)
    half = target.with_name(f".{target.name}.{os.getpid()}")
    try:
        half.write_text(text, encoding="utf-8")
        half.replace(target)
    except OSError as exc:
        half.unlink(missing_ok=True)
        raise picture_error(path, exc.strerror or str(exc)) from exc


def _dot(drawn: GraphView) -> str:
    from zbot.graph.dot import dot  # noqa: PLC0415 - not needed for text

    return dot(drawn)


def _watch(make_view: Callable[[Snapshot], GraphView], show: _Output) -> None:
    with client(wait=True) as context:
        context.graph.watch()
        shown = make_view(context.graph.snapshot())
        show(shown)
        while context.graph.wait_for(lambda seen: make_view(seen) != shown, None):  # noqa: B023
            shown = make_view(context.graph.snapshot())
            if show.separates_by_blank_line:
                print()
            show(shown)
    raise ExternalShutdownException


def _text(drawn: GraphView) -> str:
    if not drawn.nodes:
        return "no node is running"
    if drawn.mode is Mode.NODES:
        arrows = [_arrow_text(edge) for edge in drawn.edges]
        return "\n".join([*drawn.nodes, *arrows, *drawn.problems])
    blocks = [_topic_text(topic) for topic in drawn.boxes]
    connected = {name for box in drawn.boxes for name in box.publishers + box.subscriptions}
    alone = [name for name in drawn.nodes if name not in connected]
    if alone:
        blocks.append("without topics: " + ", ".join(alone))
    return "\n".join(blocks)


def _arrow_text(edge: Edge) -> str:
    return f"{edge.start} {_arrow(edge.kind)} {edge.end}  ({edge.label})"


def _arrow(kind: BoxKind) -> str:
    return "<->" if kind is BoxKind.ACTION else "->"


def _topic_text(topic: TopicView) -> str:
    publishers = ", ".join(topic.publishers) or "(nobody)"
    subscriptions = ", ".join(topic.subscriptions) or "(nobody)"
    arrow = _arrow(topic.kind)
    kind = "" if topic.kind is BoxKind.TOPIC else f" {topic.kind.value}"
    lines = [f"{publishers} {arrow} [{topic.name}{kind}] {arrow} {subscriptions}"]
    if topic.problem is not None:
        lines.append(f"    {topic.problem}")
    return "\n".join(lines)


def _document(drawn: GraphView) -> dict[str, object]:
    return {
        "nodes": list(drawn.nodes),
        "topics": [_box_document(box) for box in drawn.boxes],
        "problems": list(drawn.problems),
        "edges": [
            {"from": edge.start, "to": edge.end, "topic": edge.label or None}
            for edge in drawn.edges
        ],
    }


def _box_document(box: TopicView) -> dict[str, object]:
    return {
        "name": box.name,
        "kind": box.kind.value,
        "types": list(box.types),
        "publishers": list(box.publishers),
        "subscriptions": list(box.subscriptions),
        "clash": box.has_clash,
        "guess": box.guess,
        "problem": box.problem,
    }
