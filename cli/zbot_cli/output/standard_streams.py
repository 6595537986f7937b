"""Standard streams of the command: how they are set up, and what happens if they cannot be used."""

from __future__ import annotations

import contextlib
import errno
import os
import sys
from typing import Any

from zbot_cli.output.exit_status import Status

#: Errors of a write to a stream, and other words for the system's words.
_WRITE_FAULTS = {
    errno.EBADF: "it is closed",
    errno.ENOSPC: "",
    errno.EIO: "",
    errno.EFBIG: "",
}


def set_up() -> None:
    """Prepare the streams for the command's own output."""
    _replace_closed()
    for stream in (sys.stdout, sys.stderr):
        reconfigure: Any = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(line_buffering=True, errors="backslashreplace")
    # Control characters are escaped for a terminal only. Pipes and files get all output unchanged.
    sys.stdout, sys.stderr = map(_for_terminal, (sys.stdout, sys.stderr))


def _replace_closed() -> None:
    """Open the streams that are closed (`zbot topic list >&-`).

    Otherwise a file or a socket would get the number of a closed stream, and output would go there.
    """
    if sys.stdin is None:
        sys.stdin = _null_device(0, os.O_RDONLY)
    if sys.stdout is None:
        sys.stdout = _null_device(1, os.O_RDONLY)  # so that writing fails, and the user is told
    if sys.stderr is None:
        sys.stderr = _null_device(2, os.O_WRONLY)


def _null_device(number: int, flags: int) -> Any:
    opened = os.open(os.devnull, flags)
    if opened != number:
        os.dup2(opened, number)
        os.close(opened)
    return open(number, "r" if number == 0 else "w", encoding="utf-8", closefd=False)


def _for_terminal(stream: Any) -> Any:
    if not stream.isatty():
        return stream
    from zbot.terminal.text import TerminalStream  # noqa: PLC0415 - not needed without a terminal

    return TerminalStream(stream)


def restore() -> None:
    """Let the user's own programs use the streams as Python made them."""
    # `stream` is the original of a `TerminalStream`.
    sys.stdout, sys.stderr = (getattr(one, "stream", one) for one in (sys.stdout, sys.stderr))
    if sys.__stdout__ is None:
        silence_stdout()  # programs may print


def flush() -> int:
    """Write the rest of the output. Return the exit code if this failed, else 0."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        silence_stdout()
    except OSError as error:
        return report_fault(error)
    return Status.OK


def silence_stdout() -> None:
    """Send all later output to the null device, e.g. because its reader (`| head`) has ended.

    Python writes the rest of the output once more at its exit.
    """
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def report_fault(error: OSError) -> Status:
    """Print on stderr what the system refused, e.g. to write the output or a file."""
    reason = os.strerror(error.errno) if error.errno else str(error)
    if error.filename is None and error.errno in _WRITE_FAULTS:
        silence_stdout()
        text = f"cannot write the output: {_WRITE_FAULTS[error.errno] or reason}"
    elif error.errno in {errno.EMFILE, errno.ENFILE}:
        text = "too many files are open: raise the limit, for example with `ulimit -n 1024`"
    elif error.filename is not None:
        text = f"cannot use {error.filename}: {reason}{_advice(error.filename)}"
    else:
        text = f"the system refused an operation: {reason}"
    # If stderr cannot be written either, the exit code still says that something failed.
    with contextlib.suppress(OSError):
        print(text, file=sys.stderr)
    return Status.ERROR


def _advice(file: object) -> str:
    from pathlib import Path  # noqa: PLC0415 - only for errors

    from zbot.package.user_folders import settings_folder  # noqa: PLC0415 - only for errors

    if not isinstance(file, (str, bytes)):  # the number of an open file
        return ""
    path, settings = Path(os.fsdecode(file)), settings_folder()
    if settings not in (path, *path.parents) and path not in settings.parents:
        return ""
    return "\n\nhint: set XDG_CONFIG_HOME to a folder in which you can write"
