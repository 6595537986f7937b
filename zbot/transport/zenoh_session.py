"""Opening of Zenoh sessions. Only this module of zbot calls `zenoh.open()`."""

from __future__ import annotations

import errno
import os
import sys

import zenoh

from zbot.transport.errors import SessionError, TransportError

_SHARED_MEMORY = "transport/shared_memory/enabled"
_FILES = 40  # a session opens 19, and links and imported modules need more


# A closed session that had a link with shared memory leaves an open file and 50 kB of memory.
_MOST_WITH_SHARED_MEMORY = 50


class _Library:
    user: int | None = None  #: id of the process that opens sessions with the loaded library
    opened = 0  #: how many sessions the library has opened


def prepare() -> None:
    """Load Zenoh's library again if this process is a fork of a process that had a session.

    The library's threads do not exist in a forked child, and the library does not start them again,
    so `zenoh.open()` would wait for ever. A copy of the library has its own state. The module
    `zenoh` stays the same object, and has the classes of the copy from now on. This takes 20 ms.

    Raises:
        TransportError: The library cannot be copied or loaded.
    """
    if _Library.user not in {None, os.getpid()}:
        try:
            _load_copy()
        except (OSError, ImportError) as exc:
            raise TransportError(
                "this process is a fork of a process with nodes, and cannot have nodes itself "
                f"({exc!s}): start it with multiprocessing.get_context('spawn')"
            ) from exc
    _Library.user = os.getpid()


def _load_copy() -> None:
    import importlib.machinery  # noqa: PLC0415 - only forked processes need it
    import importlib.util  # noqa: PLC0415 - as above
    import shutil  # noqa: PLC0415 - as above
    import tempfile  # noqa: PLC0415 - as above

    name = "zenoh.zenoh"
    original = str(sys.modules[name].__file__)
    with tempfile.TemporaryDirectory() as folder:
        # The system loads a file only once, so it must be another file.
        path = shutil.copy(original, folder)
        loader = importlib.machinery.ExtensionFileLoader(name, path)
        spec = importlib.machinery.ModuleSpec(name, loader, origin=path)
        module = importlib.util.module_from_spec(spec)
        loader.exec_module(module)
    module.__file__ = original  # a child of this process copies it too
    sys.modules[name] = module
    for package in (zenoh, sys.modules.get("zenoh.ext")):
        if package is not None:
            importlib.reload(package)


def shares_memory(config: zenoh.Config) -> bool:
    """Return whether a session that is opened now will have shared memory."""
    return _may_share_memory() and config.get_json(_SHARED_MEMORY) == "true"


def _may_share_memory() -> bool:
    return _Library.opened < _MOST_WITH_SHARED_MEMORY


def open_session(what: str, config: zenoh.Config) -> zenoh.Session:
    """Open a session. `what` is the session's name in the error's text.

    Raises:
        SessionError: Zenoh cannot open the session.
        TransportError: The process may open too few files.
    """
    prepare()
    if "RUST_LOG" in os.environ:
        zenoh.try_init_log_from_env()
    _check_file_limit()
    if not _may_share_memory():  # large messages then take the way of small messages
        config.insert_json5(_SHARED_MEMORY, "false")
    try:
        session = zenoh.open(config)
    except zenoh.ZError as exc:
        raise SessionError(what, str(exc)) from exc
    _Library.opened += 1
    return session


def _check_file_limit() -> None:
    """Check that enough files can be opened. Otherwise Zenoh aborts the process, now or later.

    Raises:
        TransportError: The limit of the process is too low.
    """
    if sys.platform == "win32":  # the limit does not include sockets
        return
    opened: list[int] = []
    try:
        opened.extend(os.open(os.devnull, os.O_RDONLY) for _ in range(_FILES))
    except OSError as exc:
        if exc.errno in {errno.EMFILE, errno.ENFILE}:
            raise TransportError(
                f"the limit of open files is too low: zbot needs {_FILES} more files; "
                "raise the limit, for example with `ulimit -n 1024`"
            ) from None
        raise
    finally:
        for number in opened:
            os.close(number)
