"""Opening of Zenoh sessions. Only this module of zbot calls `zenoh.open()`."""

from __future__ import annotations

import errno
import os
import sys

import zenoh

from zbot.transport.errors import FileLimitError, SessionError

_FILES = 40  # a session opens 19, and links and imported modules need more


def open_session(what: str, config: zenoh.Config) -> zenoh.Session:
    """Open a session. `what` is the session's name in the error's text.

    Raises:
        SessionError: Zenoh cannot open the session.
        FileLimitError: The process may open too few files.
    """
    if "RUST_LOG" in os.environ:
        zenoh.try_init_log_from_env()
    _check_file_limit()
    try:
        return zenoh.open(config)
    except zenoh.ZError as exc:
        raise SessionError(what, str(exc)) from exc


def _check_file_limit() -> None:
    """Check that enough files can be opened. Otherwise Zenoh aborts the process, now or later.

    Raises:
        FileLimitError: The limit of the process is too low.
    """
    if sys.platform == "win32":  # the limit does not include sockets
        return
    opened: list[int] = []
    try:
        opened.extend(os.open(os.devnull, os.O_RDONLY) for _ in range(_FILES))
    except OSError as exc:
        if exc.errno in {errno.EMFILE, errno.ENFILE}:
            raise FileLimitError(_FILES) from None
        raise
    finally:
        for number in opened:
            os.close(number)
