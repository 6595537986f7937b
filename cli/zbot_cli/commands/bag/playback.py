"""`zbot bag play` and `zbot bag burst`: publish the messages of bags again."""

from __future__ import annotations

import contextlib
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.bag.player import Player
from zbot.bag.player_services import PlayerServices
from zbot.executor.spin_thread import SpinThread
from zbot_cli.commands.bag.options import set_log_level
from zbot_cli.commands.bag.progress_bar import progress_bar
from zbot_cli.domain.client import hidden_node
from zbot_cli.errors import CommandError
from zbot_cli.input.keyboard import has_keyboard, keys_to

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.bag.options import PlayOptions
    from zbot.bag.reader import Reader
    from zbot.node.node import Node

NODE_NAME = "rosbag2_player"


@dataclass(frozen=True)
class Playback:
    """Playback of bags with the options of `zbot bag play` or `zbot bag burst`."""

    bags: Sequence[Reader]
    options: PlayOptions
    has_keys: bool = True
    log_level: str = "info"
    bar_hz: float = 0
    bar_separation_lines: int = 0
    #: Number of messages to publish without pauses at the start. 0 means all, `None` means none.
    burst_count: int | None = None

    def run(self) -> None:
        """Play until the end or Ctrl-C.

        Raises:
            BagReadError: A part of a bag is damaged.
        """
        # The thread that reads the bag may hold Python's global lock for this time, in seconds.
        # Meanwhile no message can be published. Python's default of 5 ms makes messages late.
        sys.setswitchinterval(0.0005)
        with hidden_node("play", NODE_NAME) as node, contextlib.ExitStack() as stack:
            set_log_level(node, self.log_level)
            player = Player(node, self.bags, self.options)
            PlayerServices(node, player)
            stack.enter_context(SpinThread(node, "zbot bag services"))
            if self.has_keys and has_keyboard():
                _explain_keys(node)
                stack.enter_context(keys_to(player.press))
            stack.enter_context(progress_bar(player, self.bar_hz, self.bar_separation_lines))
            if self.burst_count is not None:
                player.step(self.burst_count)
            # Ctrl-C is a usual end of a playback.
            with contextlib.suppress(KeyboardInterrupt):
                player.run()


def _explain_keys(node: Node) -> None:
    log = node.get_logger()
    log.info("Adding keyboard callbacks.")
    log.info("Press SPACE for Pause/Resume")
    log.info("Press CURSOR_RIGHT for Play Next Message")
    log.info("Press CURSOR_UP for Increase Rate 10%")
    log.info("Press CURSOR_DOWN for Decrease Rate 10%")


def remap_rules(words: list[str]) -> list[str]:
    """Return the words if all are rules for new names of topics.

    Raises:
        CommandError: A word is not a rule.
    """
    for word in words:
        old, separator, new = word.partition(":=")
        if not (old and separator and new):
            raise CommandError(f"--remap '{word}' is not OLD_TOPIC:=NEW_TOPIC")
    return words
