"""`zbot graph`: who talks to whom, as text, JSON or a picture for Graphviz."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from zbot.graph_view import Filters, GraphView, Mode, TopicView, dot, view
from zbot_cli.listing import AsJson, new_app, print_json
from zbot_cli.looking import client, snapshot

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.graph import Snapshot

app = new_app("Show which nodes talk to each other", has_verbs=False)

_ONE_HOUR_S = 3600.0


@app.callback(invoke_without_command=True)
def graph(
    mode: Annotated[Mode, typer.Option("--show", help="Which topics to show")] = Mode.ALL,
    debug: Annotated[bool, typer.Option("--debug-topics", help="Show /rosout too")] = False,
    params: Annotated[bool, typer.Option("--params", help="Show /parameter_events too")] = False,
    no_tf: Annotated[bool, typer.Option("--no-tf", help="Leave transforms out")] = False,
    no_dead_sinks: Annotated[
        bool, typer.Option("--no-dead-sinks", help="Leave out what nobody subscribes to")
    ] = False,
    no_leaf_topics: Annotated[
        bool, typer.Option("--no-leaf-topics", help="Leave out topics with one connection")
    ] = False,
    include_hidden: Annotated[
        bool, typer.Option("--include-hidden", help="Show hidden names too")
    ] = False,
    as_dot: Annotated[bool, typer.Option("--dot", help="Print Graphviz's language")] = False,
    watch: Annotated[bool, typer.Option("--watch", help="Print again at each change")] = False,
    as_json: AsJson = False,
) -> None:
    """Show which nodes talk to each other."""
    filters = Filters(
        debug=not debug,
        tf=no_tf,
        params=not params,
        dead_sinks=no_dead_sinks,
        leaf_topics=no_leaf_topics,
        hidden=not include_hidden,
    )

    def look(seen: Snapshot) -> GraphView:
        return view(seen, mode, filters)

    def show(drawn: GraphView) -> None:
        if as_json:
            print_json(_document(drawn))
        else:
            print(dot(drawn) if as_dot else _text(drawn))

    if watch:
        _watch(look, show)
    else:
        show(look(snapshot()))


def _watch(look: Callable[[Snapshot], GraphView], show: Callable[[GraphView], None]) -> None:
    with client(wait=True) as context:
        context.graph.watch()
        shown = look(context.graph.snapshot())
        show(shown)
        while True:
            before = shown
            if context.graph.wait_for(lambda seen: look(seen) != before, _ONE_HOUR_S):  # noqa: B023
                shown = look(context.graph.snapshot())
                print()
                show(shown)


def _text(drawn: GraphView) -> str:
    if not drawn.nodes:
        return "no node is running"
    if drawn.mode is Mode.NODES:
        talking = [f"{edge.start} -> {edge.end}  ({edge.label})" for edge in drawn.edges]
        return "\n".join([*drawn.nodes, *talking])
    blocks = [_topic_text(topic) for topic in drawn.boxes]
    connected = {name for box in drawn.boxes for name in box.publishers + box.subscriptions}
    alone = [name for name in drawn.nodes if name not in connected]
    if alone:
        blocks.append("without topics: " + ", ".join(alone))
    return "\n".join(blocks)


def _topic_text(topic: TopicView) -> str:
    publishers = ", ".join(topic.publishers) or "(nobody)"
    subscriptions = ", ".join(topic.subscriptions) or "(nobody)"
    lines = [f"{publishers} -> [{topic.name}] -> {subscriptions}"]
    if topic.has_clash:
        lines.append(f"    two types cannot hear each other: {', '.join(topic.types)}")
    if topic.guess is not None:
        lines.append(f"    nobody publishes {topic.name}: is {topic.guess} meant?")
    return "\n".join(lines)


def _document(drawn: GraphView) -> dict[str, object]:
    return {
        "nodes": list(drawn.nodes),
        "topics": [
            {
                "name": box.name,
                "types": list(box.types),
                "publishers": list(box.publishers),
                "subscriptions": list(box.subscriptions),
                "clash": box.has_clash,
                "guess": box.guess,
            }
            for box in drawn.boxes
        ],
        "edges": [
            {"from": edge.start, "to": edge.end, "topic": edge.label or None}
            for edge in drawn.edges
        ],
    }
