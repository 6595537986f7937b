"""Recorder and player with the signatures of ROS 2's `rosbag2_py`."""

from __future__ import annotations

import contextlib
import threading
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.bag import conversion, player, recorder
from zbot.bag.errors import BagValueError
from zbot.bag.options import StorageOptions
from zbot.bag.player_services import PlayerServices
from zbot.bag.reader import Reader
from zbot.context import Context
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.executor.spin_thread import SpinThread
from zbot.log import LoggingSeverity
from zbot.node.node import Node

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from zbot.bag.options import PlayOptions, RecordOptions

_LEVELS = {
    "debug": LoggingSeverity.DEBUG,
    "info": LoggingSeverity.INFO,
    "warn": LoggingSeverity.WARN,
    "error": LoggingSeverity.ERROR,
    "fatal": LoggingSeverity.FATAL,
}
DEFAULT_NAME = "rosbag2_recorder"
_PLAYER_NAME = "rosbag2_player"


class _Cancellations:
    """Recordings or playbacks that can be cancelled, also before they have begun."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running: set[_Cancellation] = set()

    @contextlib.contextmanager
    def one(self) -> Iterator[_Cancellation]:
        """Yield the cancellation of one recording or playback."""
        cancellation = _Cancellation()
        with self._lock:
            self._running.add(cancellation)
        try:
            yield cancellation
        finally:
            with self._lock:
                self._running.discard(cancellation)

    def cancel(self) -> None:
        """Cancel all recordings or playbacks."""
        with self._lock:
            for cancellation in self._running:
                cancellation.cancel()


class _Cancellation:
    """Cancellation of one recording or playback. `cancel` may be called before `attach`."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._end: Callable[[], None] | None = None
        self._is_cancelled = False

    def attach(self, end: Callable[[], None]) -> None:
        """Let `cancel` call a function. Call it now if `cancel` was called already."""
        with self._lock:
            self._end = end
            is_cancelled = self._is_cancelled
        if is_cancelled:
            end()

    def cancel(self) -> None:
        """Call the attached function, or call the function when it is attached later."""
        with self._lock:
            self._is_cancelled = True
            end = self._end
        if end is not None:
            end()


_PLAYBACKS = _Cancellations()
_RECORDINGS = _Cancellations()


class Player:
    """Player of bags.

    Args:
        log_level: `debug`, `info`, `warn`, `error` or `fatal`.

    Raises:
        BagValueError: There is no such level.
    """

    def __init__(self, log_level: str = "info") -> None:
        self._level = _level(log_level)

    def play(
        self,
        storage_options: StorageOptions | Sequence[StorageOptions],
        play_options: PlayOptions,
    ) -> None:
        """Play a bag, or several bags at the same time. Return at the end or after `cancel`.

        Raises:
            BagNotFoundError: There is no bag.
            BagReadError: A bag cannot be read.
        """
        self._play(storage_options, play_options, burst=None)

    def burst(
        self, storage_options: StorageOptions, play_options: PlayOptions, num_messages: int
    ) -> None:
        """Start playing, publish the first messages without waiting, and then stay paused.

        `num_messages` 0 means all messages. The errors are those of `play`.
        """
        play_options.start_paused = True
        self._play(storage_options, play_options, burst=num_messages)

    @staticmethod
    def cancel() -> None:
        """End all playbacks of this process."""
        _PLAYBACKS.cancel()

    def _play(
        self,
        storage_options: StorageOptions | Sequence[StorageOptions],
        play_options: PlayOptions,
        *,
        burst: int | None,
    ) -> None:
        if isinstance(storage_options, StorageOptions):
            storage_options = [storage_options]
        with _PLAYBACKS.one() as cancellation, contextlib.ExitStack() as stack:
            bags = [
                stack.enter_context(Reader(options.uri, options.storage_id))
                for options in storage_options
            ]
            node = stack.enter_context(
                _node(f"{play_options.node_prefix}{_PLAYER_NAME}", self._level)
            )
            playing = player.Player(node, bags, play_options)
            PlayerServices(node, playing)
            stack.enter_context(SpinThread(node, "zbot bag services"))
            if burst is not None:
                playing.step(burst)
            cancellation.attach(playing.stop)
            playing.run()


class Recorder:
    """Recorder of topics.

    Args:
        log_level: `debug`, `info`, `warn`, `error` or `fatal`.

    Raises:
        BagValueError: There is no such level.
    """

    def __init__(self, log_level: str = "info") -> None:
        self._level = _level(log_level)

    def record(
        self,
        storage_options: StorageOptions,
        record_options: RecordOptions,
        node_name: str = DEFAULT_NAME,
    ) -> None:
        """Record until `cancel` or Ctrl-C.

        Raises:
            BagExistsError: The bag exists.
            BagWriteError: The bag cannot be written, e.g. because the disk is full.
        """
        name = f"{record_options.node_prefix}{node_name}"
        with _RECORDINGS.one() as cancellation, contextlib.ExitStack() as stack:
            node = stack.enter_context(
                _node(name, self._level, use_sim_time=record_options.use_sim_time)
            )
            recording = recorder.Recorder(node, storage_options, record_options)
            stack.callback(recording.stop)
            executor = SingleThreadedExecutor(context=node.context)
            executor.add_node(node)
            cancellation.attach(recording.end)
            recording.run(executor)

    @staticmethod
    def cancel() -> None:
        """End all recordings of this process."""
        _RECORDINGS.cancel()


def bag_rewrite(input_options: Sequence[StorageOptions], output_options_path: str) -> None:
    """Write new bags from bags, as `ros2 bag convert`.

    Args:
        input_options: The bags.
        output_options_path: YAML file with the key `output_bags`.

    Raises:
        BagValueError: The file is not valid.
        BagNotFoundError: There is no bag.
        BagReadError: A bag cannot be read.
        BagWriteError: A bag cannot be written.
    """
    outputs = conversion.read_outputs(Path(output_options_path))
    with contextlib.ExitStack() as stack:
        bags = [
            stack.enter_context(Reader(options.uri, options.storage_id))
            for options in input_options
        ]
        for output in outputs:
            conversion.convert(bags, output)


def _level(name: str) -> LoggingSeverity:
    level = _LEVELS.get(name)
    if level is None:
        raise BagValueError(f"the log level cannot be {name!r}: choose one of {', '.join(_LEVELS)}")
    return level


@contextlib.contextmanager
def _node(name: str, level: LoggingSeverity, *, use_sim_time: bool = False) -> Iterator[Node]:
    """Yield a node in a context of its own, as rosbag2 does."""
    context = Context()
    context.init([])
    try:
        node = Node(
            name,
            context=context,
            cli_args=["--ros-args", "-p", "use_sim_time:=true"] if use_sim_time else None,
            start_parameter_services=False,
        )
        node.get_logger().set_level(level)
        yield node
    finally:
        context.shutdown()
