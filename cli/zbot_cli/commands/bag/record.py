"""Command line of `zbot bag record`."""

from __future__ import annotations

from datetime import timedelta
from enum import Enum
from pathlib import Path
from typing import Annotated, ClassVar

import typer

from zbot_cli.commands.bag.options import (
    LogLevel,
    LogLevelOption,
    StorageId,
    refuse_together,
    types,
    warn,
)
from zbot_cli.input.many_values import ManyValuesCommand


class CompressionMode(str, Enum):
    """What `--compression-mode` compresses."""

    NONE = "none"
    FILE = "file"
    MESSAGE = "message"


class Preset(str, Enum):
    """rosbag2's presets for the form of an MCAP file, and `zstd`, which is zbot's own default."""

    ZSTD = "zstd"
    NONE = "none"
    FASTWRITE = "fastwrite"
    ZSTD_FAST = "zstd_fast"
    ZSTD_SMALL = "zstd_small"


class RecordCommand(ManyValuesCommand):
    """Parser of options that take several values."""

    many: ClassVar[frozenset[str]] = frozenset(
        {
            "--topics",
            "--services",
            "--actions",
            "--topic-types",
            "--exclude-topics",
            "--exclude-topic-types",
            "--exclude-services",
            "--exclude-actions",
            "--custom-data",
        }
    )


def record(
    topics_positional: Annotated[
        list[str] | None, typer.Argument(metavar="[TOPIC]...", help="Topics, as with --topics")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="Folder; default: a name with date and time"),
    ] = None,
    storage: Annotated[
        StorageId, typer.Option("-s", "--storage", help="Format of the bag")
    ] = StorageId.MCAP,
    topics: Annotated[list[str] | None, typer.Option("--topics", help="Topics to record")] = None,
    services: Annotated[
        list[str] | None, typer.Option("--services", help="Services whose events to record")
    ] = None,
    actions: Annotated[
        list[str] | None, typer.Option("--actions", help="Actions to record")
    ] = None,
    topic_types: Annotated[
        list[str] | None, typer.Option("--topic-types", help="Record topics of these types")
    ] = None,
    everything: Annotated[
        bool, typer.Option("-a", "--all", help="Record all topics, services and actions")
    ] = False,
    all_topics: Annotated[bool, typer.Option("--all-topics", help="Record all topics")] = False,
    all_services: Annotated[
        bool, typer.Option("--all-services", help="Record all services")
    ] = False,
    all_actions: Annotated[bool, typer.Option("--all-actions", help="Record all actions")] = False,
    regex: Annotated[
        str, typer.Option("-e", "--regex", help="Record names that contain this expression")
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
    exclude_topic_types: Annotated[
        list[str] | None, typer.Option("--exclude-topic-types", help="Leave out these types")
    ] = None,
    exclude_services: Annotated[
        list[str] | None, typer.Option("--exclude-services", help="Leave out these services")
    ] = None,
    exclude_actions: Annotated[
        list[str] | None, typer.Option("--exclude-actions", help="Leave out these actions")
    ] = None,
    include_unpublished_topics: Annotated[
        bool,
        typer.Option("--include-unpublished-topics", help="Record topics without publishers too"),
    ] = False,
    include_hidden_topics: Annotated[
        bool, typer.Option("--include-hidden-topics", help="Record hidden topics too")
    ] = False,
    ignore_leaf_topics: Annotated[
        bool, typer.Option("--ignore-leaf-topics", help="Leave out topics that nobody reads")
    ] = False,
    no_discovery: Annotated[
        bool, typer.Option("--no-discovery", help="Record only topics that exist at the start")
    ] = False,
    polling_interval: Annotated[
        int, typer.Option("-p", "--polling-interval", min=1, help="Search for topics every N ms")
    ] = 100,
    qos_profile_overrides_path: Annotated[
        Path | None,
        typer.Option("--qos-profile-overrides-path", help="YAML file of profiles by topic"),
    ] = None,
    max_bag_size: Annotated[
        int,
        typer.Option("-b", "--max-bag-size", min=0, help="Maximum bytes of a file; 0: no limit"),
    ] = 0,
    max_bag_duration: Annotated[
        int,
        typer.Option(
            "-d", "--max-bag-duration", min=0, help="Maximum seconds of a file; 0: no limit"
        ),
    ] = 0,
    max_cache_size: Annotated[
        int,
        typer.Option(
            "--max-cache-size", min=0, help="Bytes that may wait for the disk; 0: no limit"
        ),
    ] = 100 * 2**20,
    max_cache_duration: Annotated[
        int,
        typer.Option(
            "--max-cache-duration", min=0, help="Seconds that --snapshot-mode keeps; 0: no limit"
        ),
    ] = 0,
    snapshot_mode: Annotated[
        bool, typer.Option("--snapshot-mode", help="Write only when ~/snapshot is called")
    ] = False,
    repeat_latched: Annotated[
        bool, typer.Option("--repeat-latched", help="Begin each file with the latched messages")
    ] = False,
    compression_mode: Annotated[
        CompressionMode,
        typer.Option("--compression-mode", help="Compress whole files or each message"),
    ] = CompressionMode.NONE,
    compression_format: Annotated[
        str, typer.Option("--compression-format", help="Format of --compression-mode: zstd")
    ] = "",
    storage_preset_profile: Annotated[
        Preset, typer.Option("--storage-preset-profile", help="How the MCAP file is written")
    ] = Preset.ZSTD,
    storage_config_file: Annotated[
        Path | None,
        typer.Option("--storage-config-file", help="YAML file with settings of the MCAP file"),
    ] = None,
    custom_data: Annotated[
        list[str] | None, typer.Option("--custom-data", help="KEY=VALUE ... for the metadata")
    ] = None,
    start_paused: Annotated[
        bool, typer.Option("--start-paused", help="Wait for the space key")
    ] = False,
    disable_keyboard_controls: Annotated[
        bool, typer.Option("--disable-keyboard-controls", help="Do not read keys")
    ] = False,
    use_sim_time: Annotated[
        bool, typer.Option("--use-sim-time", help="Take the times from /clock")
    ] = False,
    node_name: Annotated[
        str, typer.Option("--node-name", help="Name of the recorder's node")
    ] = "rosbag2_recorder",
    log_level: LogLevelOption = LogLevel.INFO,
    serialization_format: Annotated[
        str, typer.Option("-f", "--serialization-format", help="Accepted; no effect", hidden=True)
    ] = "cdr",
    compression_queue_size: Annotated[
        int, typer.Option("--compression-queue-size", help="Accepted; no effect", hidden=True)
    ] = 1,
    compression_threads: Annotated[
        int, typer.Option("--compression-threads", help="Accepted; no effect", hidden=True)
    ] = 0,
    compression_threads_priority: Annotated[
        int, typer.Option("--compression-threads-priority", help="Accepted; no effect", hidden=True)
    ] = 0,
) -> None:
    """Record topics into a bag."""
    from zbot.bag.options import RecordOptions, StorageOptions  # noqa: PLC0415 - only to record
    from zbot.bag.qos_profiles import read_overrides  # noqa: PLC0415 - as above
    from zbot_cli.commands.bag import recording  # noqa: PLC0415 - as above

    refuse_together({"TOPIC": bool(topics_positional), "--topics": bool(topics)})
    if topics_positional:
        warn('Positional "topics" argument deprecated. Please use optional "--topics" instead.')
    _check_format(compression_mode, compression_format)
    overrides = qos_profile_overrides_path
    options = RecordOptions(
        all_topics=everything or all_topics,
        all_services=everything or all_services,
        all_actions=everything or all_actions,
        is_discovery_disabled=no_discovery,
        topics=[*(topics or ()), *(topics_positional or ())],
        topic_types=types(topic_types),
        services=services or [],
        actions=actions or [],
        exclude_topics=exclude_topics or [],
        exclude_topic_types=types(exclude_topic_types),
        exclude_service_events=exclude_services or [],
        exclude_actions=exclude_actions or [],
        topic_polling_interval=timedelta(milliseconds=polling_interval),
        regex=regex,
        exclude_regex=exclude_regex,
        compression_mode=compression_mode.value,
        topic_qos_profile_overrides={} if overrides is None else read_overrides(overrides),
        include_hidden_topics=include_hidden_topics,
        include_unpublished_topics=include_unpublished_topics,
        start_paused=start_paused,
        ignore_leaf_topics=ignore_leaf_topics,
        use_sim_time=use_sim_time,
    )
    config = storage_config_file
    recording.Recording(
        options,
        StorageOptions(
            uri="" if output is None else str(output),
            storage_id=storage.value,
            max_bagfile_size=max_bag_size,
            max_bagfile_duration=max_bag_duration,
            max_cache_size=max_cache_size,
            storage_preset_profile=storage_preset_profile.value,
            storage_config_uri="" if config is None else str(config),
            snapshot_mode=snapshot_mode,
            custom_data=recording.custom_data(custom_data or []),
            max_cache_duration=max_cache_duration,
            repeat_latched=repeat_latched,
        ),
        has_keys=not disable_keyboard_controls,
        node_name=node_name,
        log_level=log_level.value,
    ).run()


def _check_format(mode: CompressionMode, compression_format: str) -> None:
    if compression_format and mode is CompressionMode.NONE:
        raise typer.BadParameter("Cannot specify compression format without a compression mode.")
    if compression_format not in {"", "zstd"}:
        raise typer.BadParameter(
            f"--compression-format cannot be '{compression_format}': zbot writes zstd"
        )
