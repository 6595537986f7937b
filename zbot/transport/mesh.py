"""Mesh of a domain: the sessions that are linked to each other, and not only to the router.

Each link takes memory and work in two sessions, so the links of 60 sessions keep one CPU busy. A
domain's first sessions are in its mesh. Their messages do not go through the router, so they also
arrive while the router is replaced. Later sessions are clients of the router
(docs/design/meeting-point.md).
"""

from __future__ import annotations

import contextlib
from typing import IO

from zbot.package.user_folders import make_private
from zbot.transport import background_process, membership

PLACES = 12  #: the most sessions of one user in the mesh of a domain


class Mesh:
    """The mesh of one domain on this machine.

    Args:
        domain: 0 to 232.
    """

    def __init__(self, domain: int) -> None:
        self._domain = domain
        self._place: IO[str] | None = None

    def enter(self) -> bool:
        """Reserve a place until `leave` or the end of this process. Return `False` if none is free.

        Each place has a file. If the files cannot be written, this returns `True`.
        """
        try:
            make_private(membership.folder())
            return any(self._take(number) for number in range(PLACES))
        except OSError:  # e.g. the folder is read-only
            return True

    def _take(self, number: int) -> bool:
        path = background_process.lock_path(f"mesh-{self._domain}-{number}")
        with contextlib.ExitStack() as files:
            file = files.enter_context(path.open("a", encoding="utf-8"))
            if background_process.lock(file):
                self._place = file
                files.pop_all()  # the file stays open, because closing it gives the place back
                return True
        return False

    def leave(self) -> None:
        """Give the place back. Do nothing if this session has none."""
        if self._place is not None:
            self._place.close()
            self._place = None
