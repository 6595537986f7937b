"""Recordings and playbacks in the background. Each has its own thread, node and context."""

from __future__ import annotations

import contextlib
import threading
import time
import traceback
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.bag.errors import BagError
from zbot.bag.player import Player
from zbot.bag.player_services import PlayerServices
from zbot.bag.reader import Reader
from zbot.bag.recorder import Recorder
from zbot.context import Context
from zbot.errors import ExternalShutdownException, ZbotError
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.executor.spin_thread import SpinThread
from zbot.log import get_logger
from zbot.node.node import Node

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.bag.options import PlayOptions, RecordOptions, StorageOptions

_START_S = 20.0  #: longest wait for the node
_STOP_S = 60.0  #: longest wait for the end; a recording may have much to write
PLAYER_NAME, RECORDER_NAME = "rosbag2_player", "rosbag2_recorder"


class _Background:
    """Work in a thread. `error` says why the work ended early."""

    def __init__(self, name: str, domain_id: int | None, *, is_client: bool = False) -> None:
        self.error = ""
        self._domain_id = domain_id
        self._is_client = is_client
        self._is_ready = threading.Event()
        self._is_ended = False
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)
        self._thread.start()
        # If the work does not start, the caller gets no object with which to stop it.
        try:
            is_ready = self._is_ready.wait(_START_S)
        except BaseException:  # Ctrl-C
            self.stop()
            raise
        if not is_ready:
            self.end()
            raise BagError(f"{name} has not started within {_START_S:g} s")

    @property
    def is_running(self) -> bool:
        """Whether the work has not ended."""
        return self._thread.is_alive()

    def join(self, timeout_s: float | None = None) -> None:
        """Wait for the end."""
        self._thread.join(timeout_s)

    def stop(self) -> None:
        """End the work, and wait for its end. After 60 s, stop waiting and set `error`."""
        self.end()
        self.join(_STOP_S)
        if self.is_running:
            self.error = f"{self._thread.name} has not ended within {_STOP_S:g} s"

    def _run(self) -> None:
        try:
            self._work()
        except ExternalShutdownException:
            pass  # the process ends
        except ZbotError as error:
            self.error = str(error)
        except Exception as error:  # noqa: BLE001 - the caller reads `error`
            self.error = f"{self._thread.name} failed: {error!r}"
            get_logger("zbot.bag").error("".join(traceback.format_exception(error)))
        finally:
            self._is_ready.set()

    def _work(self) -> None:
        raise NotImplementedError

    def _begin(self) -> None:
        self._is_ready.set()
        if self._is_ended:
            self.end()  # the first `end` came too early to reach the work

    def end(self) -> None:
        """End the work soon, also if the work has not begun yet. Do not wait for its end."""
        self._is_ended = True

    @contextlib.contextmanager
    def _node(self, name: str) -> Iterator[Node]:
        context = Context(mode="client" if self._is_client else "peer")
        context.init([], domain_id=self._domain_id)
        try:
            if self._is_client:
                context.connect(wait=True)
            node = Node(
                name,
                context=context,
                use_global_arguments=False,
                enable_rosout=False,
                start_parameter_services=False,
            )
            if self._is_ended:
                raise ExternalShutdownException
            yield node
        finally:
            context.shutdown()


class BackgroundPlayback(_Background):
    """Playback of a bag. It begins immediately. Any thread may call its methods.

    Args:
        path: The bag.
        options: How to play.
        domain_id: 0 to 232. `None` means the same as in `zbot.init`.

    Raises:
        BagError: The playback does not start.
    """

    def __init__(self, path: Path, options: PlayOptions, domain_id: int | None = None) -> None:
        self.path = path
        self._options = options
        self.player: Player | None = None  #: `None` if the bag cannot be played
        super().__init__("zbot bag playback", domain_id)

    def end(self) -> None:
        """End the playback soon. Do not wait for its end."""
        super().end()
        if self.player is not None:
            self.player.stop()

    def _work(self) -> None:
        with Reader(self.path) as bag, self._node(PLAYER_NAME) as node:
            player = Player(node, [bag], self._options)
            PlayerServices(node, player)
            with SpinThread(node, "zbot bag services"):
                self.player = player
                self._begin()
                player.run()


class BackgroundRecording(_Background):
    """Recording of topics. It begins immediately. Any thread may call its methods.

    Args:
        storage: The new bag.
        options: What to record.
        domain_id: 0 to 232. `None` means the same as in `zbot.init`.
        is_client: Whether to be a client of the domain's router, e.g. for the domain of a student.

    Raises:
        BagError: The recording does not start.
    """

    def __init__(
        self,
        storage: StorageOptions,
        options: RecordOptions,
        domain_id: int | None = None,
        *,
        is_client: bool = False,
    ) -> None:
        self.path = Path(storage.uri)
        self.started_s = time.monotonic()
        self.recorder: Recorder | None = None  #: `None` if the bag cannot be written
        self._storage, self._options = storage, options
        super().__init__("zbot bag recording", domain_id, is_client=is_client)

    @property
    def bytes(self) -> int:
        """Size of the files so far."""
        with contextlib.suppress(OSError):  # the folder was removed
            return sum(path.stat().st_size for path in self.path.iterdir())
        return 0

    def end(self) -> None:
        """End the recording soon. Do not wait for its end."""
        super().end()
        if self.recorder is not None:
            self.recorder.end()

    def _work(self) -> None:
        with self._node(RECORDER_NAME) as node:
            recorder = Recorder(node, self._storage, self._options)
            executor = SingleThreadedExecutor(context=node.context)
            executor.add_node(node)
            self.recorder = recorder
            self._begin()
            try:
                recorder.run(executor)
            finally:
                recorder.stop()
