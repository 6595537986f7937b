"""Command lines of `zbot bag play` and `zbot bag burst`."""

from __future__ import annotations

import contextlib
import math
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import typer

from zbot_cli.commands.bag.options import (
    BagPath,
    LogLevel,
    LogLevelOption,
    Storage,
    open_bag,
    refuse_together,
    without_storages,
)
from zbot_cli.input.many_values import ManyValuesCommand

if TYPE_CHECKING:
    from collections.abc import Iterator

_CLOCK_HZ = 40  # rate of `--clock` without a number, as in ros2


_BAR_HZ = 3
_BAR_SEPARATION_LINES = 2


class MessageOrder(str, Enum):
    """Values of `--message-order`: the time by which messages are sorted."""

    RECEIVED = "received"
    SENT = "sent"


class RequestSource(str, Enum):
    """Values of `--service-requests-source`: use the events of servers or of clients."""

    SERVICE = "service_introspection"
    CLIENT = "client_introspection"


class PlayCommand(ManyValuesCommand):
    """Parser of options that take several values."""

    many: ClassVar[frozenset[str]] = frozenset(
        {
            "--topics",
            "--services",
            "--actions",
            "--exclude-topics",
            "--exclude-services",
            "--exclude-actions",
            "--remap",
            "-m",
            "--clock-topics",
        }
    )

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse `--clock`, whose number may be left out, and `-i BAG STORAGE`."""
        return super().parse_args(ctx, list(_with_clock_rate(list(without_storages(args)))))


def _with_clock_rate(words: list[str]) -> Iterator[str]:
    for index, word in enumerate(words):
        following = words[index + 1] if index + 1 < len(words) else ""
        is_bare = word == "--clock" and not _is_number(following)
        yield f"--clock={_CLOCK_HZ}" if is_bare else word


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def play(
    bag_path: Annotated[
        Path | None, typer.Argument(help="Folder of the bag, or one of its files")
    ] = None,
    inputs: Annotated[
        list[Path] | None, typer.Option("-i", "--input", help="Bag; several are played as one")
    ] = None,
    storage: Storage = None,
    rate: Annotated[float, typer.Option("-r", "--rate", help="Factor of the speed")] = 1.0,
    topics: Annotated[list[str] | None, typer.Option("--topics", help="Topics to play")] = None,
    services: Annotated[
        list[str] | None, typer.Option("--services", help="Services whose events to play")
    ] = None,
    actions: Annotated[list[str] | None, typer.Option("--actions", help="Actions to play")] = None,
    regex: Annotated[
        str, typer.Option("-e", "--regex", help="Play names that contain this expression")
    ] = "",
    exclude_regex: Annotated[
        str,
        typer.Option(
            "-x", "--exclude-regex", "--exclude", help="Leave out names with this expression"
        ),
    ] = "",
    exclude_topics: Annotated[
        list[str] | None, typer.Option("--exclude-topics", help="Leave out these topics")
    ] = None,
    exclude_services: Annotated[
        list[str] | None, typer.Option("--exclude-services", help="Leave out these services")
    ] = None,
    exclude_actions: Annotated[
        list[str] | None, typer.Option("--exclude-actions", help="Leave out these actions")
    ] = None,
    qos_profile_overrides_path: Annotated[
        Path | None,
        typer.Option("--qos-profile-overrides-path", help="YAML file of profiles by topic"),
    ] = None,
    loop: Annotated[bool, typer.Option("-l", "--loop", help="Begin again at the end")] = False,
    remap: Annotated[
        list[str] | None, typer.Option("-m", "--remap", help="OLD:=NEW ... names of topics")
    ] = None,
    clock: Annotated[
        float, typer.Option("--clock", metavar="[HZ]", help="Publish /clock; without HZ: 40")
    ] = 0.0,
    clock_topics: Annotated[
        list[str] | None,
        typer.Option("--clock-topics", help="Publish /clock with each message of these topics"),
    ] = None,
    clock_topics_all: Annotated[
        bool, typer.Option("--clock-topics-all", help="Publish /clock with each message")
    ] = False,
    delay: Annotated[
        float, typer.Option("-d", "--delay", min=0, help="Seconds to wait at the start")
    ] = 0.0,
    start_offset: Annotated[
        float, typer.Option("--start-offset", min=0, help="Seconds to leave out at the start")
    ] = 0.0,
    playback_duration: Annotated[
        float, typer.Option("--playback-duration", help="Seconds to play; below 0: all")
    ] = -1.0,
    playback_until_sec: Annotated[
        float,
        typer.Option(
            "--playback-until-sec", help="Time of the last message, in seconds; below 0: all"
        ),
    ] = -1.0,
    playback_until_nsec: Annotated[
        int, typer.Option("--playback-until-nsec", help="The same in nanoseconds")
    ] = -1,
    start_paused: Annotated[
        bool, typer.Option("-p", "--start-paused", help="Wait for the space key")
    ] = False,
    disable_keyboard_controls: Annotated[
        bool, typer.Option("--disable-keyboard-controls", help="Do not read keys")
    ] = False,
    read_ahead_queue_size: Annotated[
        int, typer.Option("--read-ahead-queue-size", min=1, help="Messages to read in advance")
    ] = 1000,
    message_order: Annotated[
        MessageOrder, typer.Option("--message-order", help="Times by which messages are published")
    ] = MessageOrder.RECEIVED,
    wait_for_all_acked: Annotated[
        int,
        typer.Option(
            "--wait-for-all-acked",
            metavar="MS",
            help="Milliseconds to wait at the end for subscribers; 0: no limit",
        ),
    ] = -1,
    publish_service_requests: Annotated[
        bool, typer.Option("--publish-service-requests", help="Call the recorded services")
    ] = False,
    service_requests_source: Annotated[
        RequestSource,
        typer.Option("--service-requests-source", help="Where the requests come from"),
    ] = RequestSource.SERVICE,
    send_actions_as_client: Annotated[
        bool, typer.Option("--send-actions-as-client", help="Send the recorded goals to the server")
    ] = False,
    progress_bar: Annotated[
        int,
        typer.Option(
            "--progress-bar-update-rate",
            "--progress-bar",
            metavar="HZ",
            help="Updates of the progress bar per second; 0: no bar",
        ),
    ] = _BAR_HZ,
    progress_bar_separation_lines: Annotated[
        int,
        typer.Option("--progress-bar-separation-lines", min=0, help="Empty lines above the bar"),
    ] = _BAR_SEPARATION_LINES,
    log_level: LogLevelOption = LogLevel.INFO,
    storage_config_file: Annotated[
        Path | None, typer.Option("--storage-config-file", help="Accepted; no effect", hidden=True)
    ] = None,
    disable_loan_message: Annotated[
        bool, typer.Option("--disable-loan-message", help="Accepted; no effect", hidden=True)
    ] = False,
) -> None:
    """Publish the messages of a bag again."""
    from zbot.bag import options as bag_options  # noqa: PLC0415 - needed only to play
    from zbot.bag.qos_profiles import read_overrides  # noqa: PLC0415 - as above
    from zbot_cli.commands.bag import playback  # noqa: PLC0415 - as above

    _check_positive("--rate", rate)
    refuse_together({"BAG": bag_path is not None, "--input": bool(inputs)})
    refuse_together(
        {
            "--clock": clock != 0,
            "--clock-topics": bool(clock_topics),
            "--clock-topics-all": clock_topics_all,
        }
    )
    refuse_together(
        {
            "--playback-until-sec": playback_until_sec >= 0,
            "--playback-until-nsec": playback_until_nsec >= 0,
        }
    )
    if clock < 0:
        _check_positive("--clock", clock)
    overrides = qos_profile_overrides_path
    options = bag_options.PlayOptions(
        rate=rate,
        topics_to_filter=topics or [],
        services_to_filter=services or [],
        actions_to_filter=actions or [],
        regex_to_filter=regex,
        exclude_regex_to_filter=exclude_regex,
        exclude_topics_to_filter=exclude_topics or [],
        exclude_service_events_to_filter=exclude_services or [],
        exclude_actions_to_filter=exclude_actions or [],
        topic_qos_profile_overrides={} if overrides is None else read_overrides(overrides),
        loop=loop,
        topic_remapping_options=playback.remap_rules(remap or []),
        clock_publish_frequency=clock,
        clock_publish_on_topic_publish=clock_topics_all,
        clock_topics=clock_topics or [],
        delay=delay,
        start_offset=start_offset,
        playback_duration=playback_duration,
        playback_until_timestamp=(
            playback_until_nsec if playback_until_sec < 0 else int(playback_until_sec * 1e9)
        ),
        start_paused=start_paused,
        read_ahead_queue_size=read_ahead_queue_size,
        message_order=bag_options.MessageOrder[f"{message_order.name}_TIMESTAMP"],
        publish_service_requests=publish_service_requests,
        service_requests_source=bag_options.ServiceRequestsSource[
            f"{service_requests_source.name}_INTROSPECTION"
        ],
        send_actions_as_client=send_actions_as_client,
        wait_acked_timeout=wait_for_all_acked,
    )
    paths = inputs or ([bag_path] if bag_path else [])
    if not paths:
        raise typer.BadParameter("say which bag to play: zbot bag play BAG")
    with contextlib.ExitStack() as stack:
        bags = [stack.enter_context(open_bag(path, storage)) for path in paths]
        playback.Playback(
            bags,
            options,
            has_keys=not disable_keyboard_controls,
            log_level=log_level.value,
            bar_hz=progress_bar,
            bar_separation_lines=progress_bar_separation_lines,
        ).run()


class BurstCommand(ManyValuesCommand):
    """Parser of options that take several values."""

    many: ClassVar[frozenset[str]] = frozenset(
        {"--topics", "--services", "--actions", "--remap", "-m"}
    )


def burst(
    bag_path: BagPath,
    storage: Storage = None,
    num_messages: Annotated[
        int, typer.Option("-n", "--num-messages", min=0, help="Messages to publish; 0: all")
    ] = 0,
    topics: Annotated[list[str] | None, typer.Option("--topics", help="Topics to play")] = None,
    services: Annotated[
        list[str] | None, typer.Option("--services", help="Services whose events to play")
    ] = None,
    actions: Annotated[list[str] | None, typer.Option("--actions", help="Actions to play")] = None,
    qos_profile_overrides_path: Annotated[
        Path | None,
        typer.Option("--qos-profile-overrides-path", help="YAML file of profiles by topic"),
    ] = None,
    remap: Annotated[
        list[str] | None, typer.Option("-m", "--remap", help="OLD:=NEW ... names of topics")
    ] = None,
    start_offset: Annotated[
        float, typer.Option("--start-offset", min=0, help="Seconds to leave out at the start")
    ] = 0.0,
    read_ahead_queue_size: Annotated[
        int, typer.Option("--read-ahead-queue-size", min=1, help="Messages to read in advance")
    ] = 1000,
) -> None:
    """Publish messages without pauses, then stay paused."""
    from zbot.bag.options import PlayOptions  # noqa: PLC0415 - needed only to play
    from zbot.bag.qos_profiles import read_overrides  # noqa: PLC0415 - as above
    from zbot_cli.commands.bag import playback  # noqa: PLC0415 - as above

    overrides = qos_profile_overrides_path
    options = PlayOptions(
        topics_to_filter=topics or [],
        services_to_filter=services or [],
        actions_to_filter=actions or [],
        topic_qos_profile_overrides={} if overrides is None else read_overrides(overrides),
        topic_remapping_options=playback.remap_rules(remap or []),
        start_offset=start_offset,
        start_paused=True,
        read_ahead_queue_size=read_ahead_queue_size,
    )
    with open_bag(bag_path, storage) as bag:
        playback.Playback(
            [bag],
            options,
            bar_hz=_BAR_HZ,
            bar_separation_lines=_BAR_SEPARATION_LINES,
            burst_count=num_messages,
        ).run()


def _check_positive(option: str, value: float) -> None:
    if not 0 < value < math.inf:
        raise typer.BadParameter(f"{option} {value:g} is not in the valid range (> 0.0)")
