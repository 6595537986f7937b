"""`zbot bag record`: writes the messages of topics into a bag."""

from __future__ import annotations

import contextlib
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.bag.errors import BagError, BagExistsError
from zbot.bag.packages import import_mcap
from zbot.bag.recorder import Recorder
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot_cli.commands.bag.options import set_log_level
from zbot_cli.domain.client import hidden_node
from zbot_cli.domain.waiting import hint_if_silent
from zbot_cli.errors import CommandError
from zbot_cli.input.keyboard import has_keyboard, keys_to

if TYPE_CHECKING:
    from zbot.bag.options import RecordOptions, StorageOptions
    from zbot.bag.selection import Selection

MIN_SPLIT_BYTES = 1024


@dataclass(frozen=True)
class Recording:
    """Recording with the options of `zbot bag record`. Without a `uri`, its name has the date."""

    options: RecordOptions
    storage: StorageOptions
    has_keys: bool
    node_name: str
    log_level: str

    def run(self) -> None:
        """Record until Ctrl-C.

        Raises:
            BagExistsError: The bag exists.
            BagWriteError: The bag cannot be written, e.g. because the disk is full.
            NoBagExtraError: The extra `bag` is not installed.
            CommandError: The options do not fit together.
        """
        import_mcap()
        selection = self.options.selection()
        check_selection(selection)
        self._check()
        path = Path(self.storage.uri or f"{datetime.now():rosbag2_%Y_%m_%d-%H_%M_%S}")
        if path.exists():
            raise BagExistsError(path)
        storage, uses_sim_time = replace(self.storage, uri=str(path)), self.options.use_sim_time
        with (
            hidden_node("record", self.node_name, use_sim_time=uses_sim_time) as node,
            contextlib.ExitStack() as stack,
        ):
            set_log_level(node, self.log_level)
            recorder = Recorder(node, storage, self.options)
            stack.callback(recorder.stop)
            executor = SingleThreadedExecutor(context=node.context)
            executor.add_node(node)
            hint_if_silent(node, sorted(selection.topics), lambda: True)
            if self.has_keys and has_keyboard():
                node.get_logger().info("Press SPACE for pausing/resuming")
                stack.enter_context(
                    keys_to(lambda key: recorder.toggle_paused() if key == " " else None)
                )
            # Ctrl-C is the usual end of a recording.
            with contextlib.suppress(KeyboardInterrupt):
                recorder.run(executor)

    def _check(self) -> None:
        storage = self.storage
        if 0 < storage.max_bagfile_size < MIN_SPLIT_BYTES:
            raise CommandError(
                f"--max-bag-size {storage.max_bagfile_size} is too small: "
                f"choose at least {MIN_SPLIT_BYTES} bytes"
            )
        if storage.snapshot_mode and not (storage.max_cache_size or storage.max_cache_duration):
            raise CommandError(
                "In snapshot mode, either the max_cache_duration or max_cache_size shall not be "
                "set to zero."
            )
        if storage.storage_config_uri and storage.storage_id != "mcap":
            raise CommandError("--storage-config-file is only for --storage mcap")
        if self.options.use_sim_time and self.options.is_discovery_disabled:
            raise CommandError(
                "--use-sim-time and --no-discovery both set, but are incompatible settings. "
                "The /clock topic needs to be discovered to record with sim time."
            )


def check_selection(selection: Selection) -> None:
    """Check that something is selected, and that each `--exclude-...` option has an effect.

    Raises:
        CommandError: Nothing is selected, or an `--exclude-...` option has no effect.
    """
    is_wide = selection.all_topics or selection.topic_types or selection.regex
    is_any = is_wide or selection.all_services or selection.all_actions
    if not (is_any or selection.names):
        raise CommandError(
            "Need to specify at least one option out of --all, --all-topics, --all-services, "
            "--all-actions, --services, --actions, --topics, --topic-types or --regex",
            hint="for example: zbot bag record --topics /chatter",
        )
    rules = (
        (
            "regex",
            selection.exclude_regex,
            is_any,
            "--all, --all-topics, --topic-types, --all-services, --all-actions or --regex",
        ),
        (
            "topics",
            selection.exclude_topics,
            is_wide,
            "--all, --all-topics, --topic-types or --regex",
        ),
        ("topic-types", selection.exclude_types, is_wide, "--all, --all-topics or --regex"),
        (
            "services",
            selection.exclude_services,
            selection.all_services or selection.regex,
            "--all, --all-services or --regex",
        ),
        (
            "actions",
            selection.exclude_actions,
            selection.all_actions or selection.regex,
            "--all, --all-actions or --regex",
        ),
    )
    for name, value, has_effect, needed in rules:
        if value and not has_effect:
            raise CommandError(f"--exclude-{name} argument requires either {needed}")


def custom_data(words: list[str]) -> dict[str, str]:
    """Return the values of `--custom-data KEY=VALUE ...`.

    Raises:
        BagError: A word has no `=`.
    """
    pairs = [word.partition("=") for word in words]
    wrong = next((key for key, equals, _ in pairs if not (key and equals)), None)
    if wrong is not None:
        raise BagError(f"--custom-data '{wrong}' is not KEY=VALUE")
    return {key: value for key, _, value in pairs}
