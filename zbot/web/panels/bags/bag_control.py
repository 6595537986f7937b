"""Recording and playback of bags in the live page.

All browsers share one recording and one playback.
"""

from __future__ import annotations

import re
import shutil
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from zbot.bag.background import BackgroundPlayback, BackgroundRecording
from zbot.bag.errors import BagError, BagValueError
from zbot.bag.options import MAX_CACHE_BYTES, PlayOptions, RecordOptions, StorageOptions
from zbot.bag.reader import Reader
from zbot.errors import ZbotError
from zbot.observer.system import System, read_only_error
from zbot.time import S_TO_NS

if TYPE_CHECKING:
    from collections.abc import Collection

    from zbot.bag.metadata import BagMetadata

_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}")
_SUFFIXES = (".mcap", ".db3", ".bag")
_MOST_BAGS = 500


def bag_name_error(name: str, reason: str) -> BagValueError:
    """Return the error that a name is not the name of a bag in the page's folder."""
    return BagValueError(f"'{name}' is no name for a bag: {reason}")


@dataclass(frozen=True)
class FoundBag:
    """A bag in the page's folder."""

    name: str
    metadata: BagMetadata | None  #: `None` if the bag cannot be read
    problem: str = ""


class BagControl:
    """Bags in a folder, and the recording and the playback of the page.

    Any thread may call the methods.

    Args:
        system: The running system.
        folder: The folder in which the page looks for bags and records new bags.
    """

    def __init__(self, system: System, folder: Path) -> None:
        self.folder = folder
        self.recording: BackgroundRecording | None = None
        self.playback: BackgroundPlayback | None = None
        self._system = system
        self._lock = threading.Lock()
        self._known: dict[str, tuple[object, FoundBag]] = {}

    def bags(self) -> dict[str, FoundBag]:
        """Return the bags in the folder by name. The newest bag comes first.

        The call takes a while, because bags are read. The bag that is being recorded is left out,
        because each call would read it again.

        Raises:
            BagError: The folder cannot be read.
        """
        recording = self.recording
        present = recording.path if recording is not None and recording.is_running else None
        found = [path for path in self._entries() if path != present and _is_bag(path)]
        found.sort(key=_modified_s, reverse=True)
        return {bag.name: self._look(bag) for bag in found[:_MOST_BAGS]}

    def path(self, name: str) -> Path:
        """Return the path of a bag in the folder.

        Raises:
            BagValueError: There is no such bag in the folder.
            BagError: The folder cannot be read.
        """
        # A bag of another program may have any name, e.g. with spaces, so `_checked` is not used.
        # The name `..` is not found, because the folder does not list it.
        path = next((entry for entry in self._entries() if entry.name == name), None)
        if path is None or not _is_bag(path):
            raise bag_name_error(name, "there is no bag with this name")
        return path

    def record(self, name: str, topics: Collection[str] | None) -> None:
        """Begin to record topics. `None` means all topics, also topics that appear later.

        Raises:
            ViewerError: The page is read-only.
            BagValueError: The name has characters of a path, or is empty.
            BagExistsError: There is a file or a folder with this name already.
            BagError: A recording runs already.
        """
        self._check_writable("recording")
        path = self.folder / _checked(name)
        everything = RecordOptions.everything()
        options = everything if topics is None else RecordOptions(topics=list(topics))
        storage = StorageOptions(str(path), max_cache_size=MAX_CACHE_BYTES)
        with self._lock:
            if self.recording is not None and self.recording.is_running:
                raise BagError(
                    f"the page records '{self.recording.path.name}' already: "
                    "stop this recording first"
                )
            self.recording = BackgroundRecording(storage, options, self._system.domain_id)
        if self.recording.error:
            raise BagError(self.recording.error)

    def stop_recording(self) -> None:
        """End the recording. Raise `ViewerError` if the page is read-only."""
        self._check_writable("recording")
        if self.recording is not None:
            self.recording.stop()

    def play(
        self, name: str, *, offset_s: float, rate: float, topics: Collection[str] | None
    ) -> None:
        """Play a bag. If another playback runs, end it first.

        Args:
            name: The name of the bag.
            offset_s: The start of the playback, in seconds from the start of the bag.
            rate: The speed, e.g. 2.0 for twice as fast as the recording.
            topics: Names of topics. `None` means all topics.

        Raises:
            ViewerError: The page is read-only.
            BagValueError: There is no such bag.
            BagError: The bag cannot be played.
        """
        self._check_writable("playing")
        if topics is not None and not topics:
            raise BagError("no topic is selected")
        options = PlayOptions(rate=rate, topics_to_filter=list(topics or ()), start_offset=offset_s)
        with self._lock:
            self._stop_playing()
            self.playback = BackgroundPlayback(self.path(name), options, self._system.domain_id)
        if self.playback.error:
            raise BagError(self.playback.error)

    def playing(self, name: str) -> BackgroundPlayback | None:
        """Return the playback of a bag, or `None` if this bag is not being played."""
        playback = self.playback
        if playback is None or playback.path.name != name or not playback.is_running:
            return None
        return playback

    def stop_playing(self) -> None:
        """End the playback. Raise `ViewerError` if the page is read-only."""
        self._check_writable("playing")
        with self._lock:
            self._stop_playing()

    def seek(self, name: str, offset_s: float) -> None:
        """Move the playback of a bag to a time, in seconds from the start of the bag.

        If this bag is not being played, do nothing.

        Raises:
            ViewerError: The page is read-only.
        """
        self._check_writable("playing")
        playback = self.playing(name)
        if playback is not None and playback.player is not None:
            start_ns = playback.player.bag_start_ns
            playback.player.seek(start_ns + int(offset_s * S_TO_NS), shows_state=True)

    def free_bytes(self) -> int | None:
        """Return the free space of the disk, or `None` if the folder cannot be read."""
        try:
            return shutil.disk_usage(self.folder).free
        except OSError:
            return None

    def check_player(self) -> None:
        """Raise `ViewerError` if the page may not control the playback."""
        self._check_writable("playing")

    def close(self) -> None:
        """End the recording and the playback."""
        if self.recording is not None:
            self.recording.stop()
        self._stop_playing()

    def _stop_playing(self) -> None:
        if self.playback is not None:
            self.playback.stop()
            self.playback = None

    def _check_writable(self, what: str) -> None:
        if self._system.read_only:
            raise read_only_error(what)

    def _entries(self) -> list[Path]:
        try:
            return list(self.folder.iterdir())
        except OSError as error:  # e.g. a removed USB stick
            reason = error.strerror or error
            raise BagError(f"the folder {self.folder} cannot be read: {reason}") from error

    def _look(self, path: Path) -> FoundBag:
        state = _state(path)
        known = self._known.get(path.name)
        if known is not None and known[0] == state:
            return known[1]
        try:
            with Reader(path) as bag:
                found = FoundBag(path.name, bag.metadata, bag.damage)
        except (ZbotError, OSError) as error:
            found = FoundBag(path.name, None, str(error))
        self._known[path.name] = (state, found)
        return found


_CONTROLS: WeakKeyDictionary[System, BagControl] = WeakKeyDictionary()


def control_of(system: System) -> BagControl:
    """Return the `BagControl` of a system. Its folder is the working folder of this process."""
    control = _CONTROLS.get(system)
    if control is None:
        control = _CONTROLS[system] = BagControl(system, Path.cwd())
        system.context.on_shutdown(control.close)
    return control


def _checked(name: str) -> str:
    if not _NAME.fullmatch(name):
        raise bag_name_error(name, "use letters, digits, underscores, dots and dashes")
    return name


def _is_bag(path: Path) -> bool:
    if path.suffix in _SUFFIXES:
        return path.is_file()
    return path.is_dir() and any(file.suffix in _SUFFIXES for file in path.glob("*"))


def _modified_s(path: Path) -> float:
    try:
        return path.stat().st_mtime
    except OSError:  # the bag was removed meanwhile
        return 0.0


def _state(path: Path) -> object:
    """Return a value that changes when a bag changes, or `None` if the bag was removed."""
    try:
        files = sorted(path.iterdir()) if path.is_dir() else [path]
        return [(file.name, file.stat().st_size, file.stat().st_mtime_ns) for file in files]
    except OSError:
        return None
