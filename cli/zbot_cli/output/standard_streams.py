"""Standard streams of the command: how they are set up, and what errors are printed."""

from __future__ import annotations

import errno
import os
import sys
from typing import TYPE_CHECKING, Any

from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from zbot.errors import ZbotError

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
    from zbot.text.terminal import TerminalStream  # noqa: PLC0415 - not needed without a terminal

    return TerminalStream(stream)


def restore() -> None:
    """Let the user's own programs use the streams as Python made them."""
    # `stream` is the original of a `TerminalStream`.
    sys.stdout, sys.stderr = (
        getattr(stream, "stream", stream) for stream in (sys.stdout, sys.stderr)
    )
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
    _silence(sys.stdout)


def _silence(stream: Any) -> None:
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


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
    print_error(text)
    return Status.ERROR


def print_error(text: str) -> None:
    """Print on stderr. If this is not possible, the exit code still says that something failed."""
    try:
        print(text, file=sys.stderr)
    except OSError:
        # Python writes the rest once more at its exit, and from 3.14 on, it then exits with 120.
        _silence(sys.stderr)


def _advice(file: object) -> str:
    from pathlib import Path  # noqa: PLC0415 - only for errors

    from zbot.package.user_folders import settings_folder  # noqa: PLC0415 - only for errors

    if not isinstance(file, (str, bytes)):  # the number of an open file
        return ""
    path, settings = Path(os.fsdecode(file)), settings_folder()
    if settings not in (path, *path.parents) and path not in settings.parents:
        return ""
    return "\n\nhint: set XDG_CONFIG_HOME to a folder in which you can write"


def report(error: ZbotError) -> Status:
    """Print an error's message without a prefix, as ros2 does. Print the hint below it.

    If the user typed a character of a word processor, a hint is about this character.
    """
    from zbot.errors.installation import with_typed_command  # noqa: PLC0415 - only for errors
    from zbot.text.typographic import advice, advice_for_words  # noqa: PLC0415 - as above

    print_error(with_typed_command(str(error)))
    hints = [advice(str(error)) or getattr(error, "hint", None), advice_for_words(sys.argv[1:])]
    for hint in dict.fromkeys(filter(None, hints)):
        print_error(f"\nhint: {with_typed_command(hint)}")
    return Status.ERROR
