"""`zbot class record`: writes the topics of each student into a bag."""

from __future__ import annotations

import contextlib
import re
import sys
import time
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.bag.background import BackgroundRecording
from zbot.bag.errors import BagError, BagExistsError, BagWriteError
from zbot.bag.options import MAX_CACHE_BYTES, RecordOptions, StorageOptions
from zbot.bag.packages import import_mcap
from zbot.classroom.errors import ClassCommandError
from zbot.classroom.teacher.opening import command
from zbot.process.signals import install
from zbot.text.terminal import escape_control_characters
from zbot_cli.commands.class_.bag_check import NAME_KEY, NUMBER_KEY
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Collection

_LOOK_S = 2.0  #: seconds between two requests for the list of students
_NOT_IN_NAMES = re.compile(r"[^A-Za-z0-9_-]+")


class ClassRecording:
    """Recording of a class: a folder with a bag for each student.

    Args:
        folder: The folder. `None` means a folder with the date.
        numbers: Numbers of students. If it is empty, all students are recorded, also students who
            join later.
        topics: Names of topics in the students' domains. If it is empty, all topics, services and
            actions are recorded.
        max_bytes: Size of a file after which the next file begins. 0 means no limit.
    """

    def __init__(
        self, folder: Path | None, numbers: Collection[int], topics: Collection[str], max_bytes: int
    ) -> None:
        self._folder = folder or Path(f"{datetime.now():class_%Y_%m_%d-%H_%M_%S}")
        self._numbers = numbers
        self._max_bytes = max_bytes
        self._options = RecordOptions(topics=list(topics)) if topics else RecordOptions.everything()
        self._running: dict[int, BackgroundRecording] = {}
        self._reported: dict[str, str] = {}  # the last errors

    def run(self) -> None:
        """Record until Ctrl-C, also while the class does not answer.

        Raises:
            ClassroomError: No class is open on this machine.
            CommandError: One of the numbers belongs to no student.
            BagExistsError: The folder exists.
            BagWriteError: The folder cannot be made.
            NoBagExtraError: The extra `bag` is not installed.
        """
        import_mcap()
        students = _students()
        missing = next((number for number in self._numbers if number not in students), None)
        if missing is not None:
            raise CommandError(f"nobody in the class has the number {missing}: see zbot class list")
        self._make_folder()
        install(calls_ok=False)
        print(f"Recording to {self._folder}; Ctrl-C ends the recording", flush=True)
        try:
            # Ctrl-C is the usual end of a recording.
            with contextlib.suppress(KeyboardInterrupt):
                while True:
                    self._begin_new(students)
                    self._report_errors()
                    time.sleep(_LOOK_S)
                    students = self._look(students)
        finally:
            for recording in self._running.values():
                recording.end()
            for recording in self._running.values():
                recording.stop()
        self._report_errors()

    def _look(self, known: dict[int, str]) -> dict[int, str]:
        """Return the students. If the class does not answer, return the known students."""
        try:
            found = _students()
        except ClassCommandError as error:
            self._report(str(error))
            return known
        self._report("")
        return found

    def _begin_new(self, students: dict[int, str]) -> None:
        for number, name in students.items():
            if number not in self._running and number in (self._numbers or students):
                try:
                    self._begin(number, name)
                except BagError as error:  # the next turn of the loop tries again
                    self._report(str(error), f"{number:3}  ")

    def _begin(self, number: int, name: str) -> None:
        path = self._folder / f"{number}_{_NOT_IN_NAMES.sub('_', name)}"
        storage = StorageOptions(
            str(path),
            max_bagfile_size=self._max_bytes,
            max_cache_size=MAX_CACHE_BYTES,
            custom_data={NUMBER_KEY: str(number), NAME_KEY: name},
        )
        self._running[number] = BackgroundRecording(storage, self._options, number, is_client=True)
        print(escape_control_characters(f"{number:3}  {name}"), flush=True)

    def _report_errors(self) -> None:
        for number, recording in self._running.items():
            self._report(recording.error, f"{number:3}  ")

    def _report(self, error: str, prefix: str = "") -> None:
        """Print an error, if it is not the last error with this prefix."""
        if error and error != self._reported.get(prefix):
            print(f"{prefix}{error}", file=sys.stderr, flush=True)
        self._reported[prefix] = error

    def _make_folder(self) -> None:
        try:
            self._folder.mkdir(parents=True)
        except FileExistsError:
            raise BagExistsError(self._folder) from None
        except OSError as error:
            raise BagWriteError(self._folder, error.strerror or str(error)) from error


def _students() -> dict[int, str]:
    return {student["number"]: student["name"] for student in command({"op": "list"})["students"]}
