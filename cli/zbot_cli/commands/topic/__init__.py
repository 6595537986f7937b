"""Verbs of `zbot topic`: list and show topics, print, measure and publish messages."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

import typer

from zbot.wire.tokens import EntityKind
from zbot_cli.domain.client import client, full_name, note_if_nobody_runs, snapshot, snapshot_of
from zbot_cli.domain.kinds import TOPIC, visible
from zbot_cli.input.form_options import DEFAULT_FORM, FormOptions
from zbot_cli.input.option_groups import noun_option, with_option_groups
from zbot_cli.input.qos_options import DEFAULT_QOS, QosOptions
from zbot_cli.output.listing import (
    NO_DAEMON,
    AsJson,
    DaemonOptions,
    ShowTypes,
    new_app,
    print_entries,
    print_json,
    print_names,
)

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot

app = new_app("Look at topics, print and publish messages")

IncludeHidden = Annotated[
    bool, typer.Option("--include-hidden-topics", help="Consider hidden topics too")
]
ListHidden = Annotated[
    bool, typer.Option("-a", "--all", "--include-hidden-topics", help="Consider hidden topics too")
]
TopicName = Annotated[str, typer.Argument(help="Name of the topic, e.g. /chatter")]
UNKNOWN_TYPE = "unknown"


@app.callback()
def options(include_hidden_topics: IncludeHidden = False) -> None:
    """Look at topics, print and publish messages."""


@app.command("list")
@with_option_groups
def list_topics(
    ctx: typer.Context,
    show_types: ShowTypes = False,
    count: Annotated[
        bool, typer.Option("-c", "--count-topics", "--count", help="Print the number")
    ] = False,
    verbose: Annotated[
        bool, typer.Option("-v", "--verbose", help="Count publishers and subscribers")
    ] = False,
    include_hidden_topics: ListHidden = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """List the topics that have publishers or subscriptions."""
    with client() as context:
        graph = snapshot_of(context)
        foreign = _foreign(context, graph)
    note_if_nobody_runs(graph)
    hidden = include_hidden_topics or noun_option(ctx, "include_hidden_topics")
    if verbose and not (count or as_json):
        _print_verbose(graph, hidden)
        return
    topics = [*graph.topics(), *((name, [UNKNOWN_TYPE]) for name in foreign)]
    entries = visible(sorted(topics), hidden)
    facts = partial(TOPIC.facts, graph)
    print_entries(entries, facts, show_types=show_types, count=count, as_json=as_json)


def _foreign(context: object, graph: Snapshot) -> dict[str, set[EntityKind]]:
    from zbot.graph.snapshot import foreign_topics  # noqa: PLC0415 - needed only for lists

    if context.is_closed:  # type: ignore[attr-defined]
        return {}
    return foreign_topics(context.session, graph, context.get_domain_id())  # type: ignore[attr-defined]


def _print_verbose(graph: Snapshot, include_hidden: bool) -> None:
    for title, noun, kind in (
        ("Published", "publisher", EntityKind.PUBLISHER),
        ("Subscribed", "subscriber", EntityKind.SUBSCRIPTION),
    ):
        print(f"{title} topics:")
        for name, types in visible(graph.names_and_types(kind), include_hidden):
            count = len(graph.on(name, kind))
            print(f" * {name} [{', '.join(types)}] {count} {noun}{'' if count == 1 else 's'}")
        print()


@app.command("info")
@with_option_groups
def info(
    topic_name: TopicName,
    verbose: Annotated[
        bool, typer.Option("-v", "--verbose", help="Show every publisher and subscription")
    ] = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Show a topic's type, publishers and subscriptions."""
    from zbot_cli.output.endpoint import endpoint_json, endpoint_text  # noqa: PLC0415 - not needed by `list`

    graph, name = snapshot(), full_name(topic_name)
    types = TOPIC.types_of(graph, name)
    ends = {"Publisher": graph.publishers(name), "Subscription": graph.subscriptions(name)}
    if as_json:
        lists = {f"{title.lower()}s": list(map(endpoint_json, ends[title])) for title in ends}
        print_json({"name": name, "types": types, **lists})
        return
    print(f"Type: {types[0] if len(types) == 1 else types}" + ("\n" if verbose else ""))
    for title, found in ends.items():
        print(f"{title} count: {len(found)}")
        if verbose:
            print()
            for end in found:
                print(endpoint_text(end, "Topic") + "\n")


@app.command("type")
@with_option_groups
def type_of(
    topic_name: TopicName,
    include_hidden_topics: IncludeHidden = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Print a topic's type."""
    print("\n".join(TOPIC.types_of(snapshot(), full_name(topic_name))))


@app.command("find")
@with_option_groups
def find(
    ctx: typer.Context,
    topic_type: Annotated[
        str, typer.Argument(help="Type of the messages, e.g. std_msgs/msg/String")
    ],
    count: Annotated[
        bool, typer.Option("-c", "--count-topics", "--count", help="Print the number")
    ] = False,
    include_hidden_topics: ListHidden = False,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """List the topics that have the given type."""
    hidden = include_hidden_topics or noun_option(ctx, "include_hidden_topics")
    found = TOPIC.with_type(snapshot(), topic_type, include_hidden=hidden)
    print_names(found, count=count, as_json=as_json)


@app.command("echo")
@with_option_groups
def echo(
    topics: Annotated[
        list[str],
        typer.Argument(
            help="Topics, also with `*` and `**`; a type may follow", metavar="TOPIC... [TYPE]"
        ),
    ],
    qos: QosOptions = DEFAULT_QOS,
    form: FormOptions = DEFAULT_FORM,
    field: Annotated[
        list[str] | None, typer.Option("--field", help="Only this field, e.g. pose.position")
    ] = None,
    no_lost_messages: Annotated[
        bool, typer.Option("--no-lost-messages", help="Do not report losses")
    ] = False,
    raw: Annotated[bool, typer.Option("--raw", help="Print the bytes of each message")] = False,
    filter_expression: Annotated[
        str | None,
        typer.Option("--filter", metavar="EXPR", help="Only messages `m` for which EXPR is true"),
    ] = None,
    once: Annotated[bool, typer.Option("--once", help="End after the first message")] = False,
    timeout: Annotated[
        float | None, typer.Option("--timeout", help="End after this many seconds")
    ] = None,
    include_message_info: Annotated[
        bool,
        typer.Option("-i", "--include-message-info", help="Show time stamps and sequence numbers"),
    ] = False,
    clear: Annotated[
        bool, typer.Option("-c", "--clear", help="Clear the screen before each message")
    ] = False,
    node_name: Annotated[
        str | None, typer.Option("-n", "--node-name", help="Name of the subscribing node")
    ] = None,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Print the messages of topics."""
    from zbot_cli.commands.topic.echo import Echo  # noqa: PLC0415 - not needed by `list`

    shown = form.form(
        as_json=as_json,
        fields=tuple(field or ()),
        raw=raw,
        filter_expression=filter_expression,
        with_info=include_message_info,
        clear=clear,
        losses=not no_lost_messages,
    )
    Echo(
        topics,
        shown,
        qos,
        once=once,
        timeout_s=timeout,
        node_name=node_name,
        use_sim_time=daemon.use_sim_time,
    ).run()


@app.command("pub")
@with_option_groups
def pub(
    topic_name: TopicName,
    words: Annotated[
        list[str] | None,
        typer.Argument(help="Type and values; both may be left out", metavar="[TYPE] [VALUES]"),
    ] = None,
    qos: QosOptions = DEFAULT_QOS,
    rate: Annotated[float, typer.Option("-r", "--rate", help="Messages a second")] = 1.0,
    print_every: Annotated[
        int, typer.Option("-p", "--print", help="Print every N-th message; 0: none")
    ] = 1,
    once: Annotated[bool, typer.Option("-1", "--once", help="Publish one message and end")] = False,
    times: Annotated[
        int, typer.Option("-t", "--times", help="Publish this many messages and end")
    ] = 0,
    wait_matching_subscriptions: Annotated[
        int | None,
        typer.Option(
            "-w",
            "--wait-matching-subscriptions",
            help="Number of subscriptions to wait for; default 1 with --once or --times",
        ),
    ] = None,
    max_wait_time_secs: Annotated[
        float | None,
        typer.Option("--max-wait-time-secs", help="Maximum wait for subscriptions, in seconds"),
    ] = None,
    keep_alive: Annotated[
        float, typer.Option("--keep-alive", help="Seconds to stay after the last message")
    ] = 0.1,
    node_name: Annotated[
        str | None, typer.Option("-n", "--node-name", help="Name of the publishing node")
    ] = None,
    stdin: Annotated[
        bool, typer.Option("--stdin", help="Read the values from standard input")
    ] = False,
    yaml_file: Annotated[
        str | None, typer.Option("--yaml-file", help="Publish each YAML document of a file")
    ] = None,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Publish messages on a topic."""
    from zbot_cli.commands.topic.pub import Pace, Pub  # noqa: PLC0415 - not needed by `list`

    pace = Pace(
        rate_hz=rate,
        print_every=print_every,
        times=1 if once else times,
        wait_for=wait_matching_subscriptions,
        max_wait_s=max_wait_time_secs,
        keep_alive_s=keep_alive,
    )
    if once and times:
        raise typer.BadParameter("--once and --times exclude each other")
    Pub(
        topic_name,
        words or [],
        pace,
        qos,
        node_name=node_name,
        stdin=stdin,
        yaml_file=yaml_file,
        use_sim_time=daemon.use_sim_time,
    ).run()


Topics = Annotated[
    list[str] | None, typer.Argument(help="Topics, e.g. /chatter", metavar="TOPIC...")
]
Window = Annotated[int, typer.Option("-w", "--window", min=1, help="Messages to measure over")]
AllTopics = Annotated[bool, typer.Option("-a", "--all", help="All topics known at the start")]


@app.command("hz")
@with_option_groups
def hz(
    topics: Topics = None,
    window: Annotated[
        int, typer.Option("-w", "--window", min=1, help="Intervals to measure over")
    ] = 10000,
    filter_expression: Annotated[
        str | None,
        typer.Option("--filter", metavar="EXPR", help="Only messages `m` for which EXPR is true"),
    ] = None,
    wall_time: Annotated[
        bool, typer.Option("--wall-time", help="Use the system's clock despite simulated time")
    ] = False,
    all_topics: AllTopics = False,
    qos: QosOptions = DEFAULT_QOS,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Measure the rate of messages."""
    from zbot_cli.commands.topic.hz import Rates  # noqa: PLC0415 - not needed by `list`
    from zbot_cli.commands.topic.measurement import measure  # noqa: PLC0415 - not needed by `list`

    measure(
        Rates(window, filter_expression),
        topics or [],
        qos,
        all_topics=all_topics,
        as_json=as_json,
        use_sim_time=daemon.use_sim_time and not wall_time,
    )


@app.command("bw")
@with_option_groups
def bw(
    topics: Topics = None,
    window: Annotated[
        int, typer.Option("-w", "--window", min=1, help="Messages to measure over")
    ] = 100,
    all_topics: AllTopics = False,
    qos: QosOptions = DEFAULT_QOS,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Measure the bandwidth of topics."""
    from zbot_cli.commands.topic.bw import Bandwidths  # noqa: PLC0415 - not needed by `list`
    from zbot_cli.commands.topic.measurement import measure  # noqa: PLC0415 - not needed by `list`

    measure(
        Bandwidths(window),
        topics or [],
        qos,
        all_topics=all_topics,
        as_json=as_json,
        use_sim_time=daemon.use_sim_time,
    )


@app.command("delay")
@with_option_groups
def delay(
    topic_name: TopicName,
    window: Annotated[
        int, typer.Option("-w", "--window", min=1, help="Messages to measure over")
    ] = 10000,
    qos: QosOptions = DEFAULT_QOS,
    as_json: AsJson = False,
    daemon: DaemonOptions = NO_DAEMON,
) -> None:
    """Measure the age of messages when they arrive."""
    from zbot_cli.commands.topic.delay import Delays  # noqa: PLC0415 - not needed by `list`
    from zbot_cli.commands.topic.measurement import measure  # noqa: PLC0415 - not needed by `list`

    measure(
        Delays(window),
        [topic_name],
        qos,
        all_topics=False,
        as_json=as_json,
        use_sim_time=daemon.use_sim_time,
    )
