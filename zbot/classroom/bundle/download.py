"""Download of wheels. A file that is whole is not fetched again."""

from __future__ import annotations

import contextlib
import errno
import hashlib
import http.client
import ssl
import urllib.error
import urllib.request
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import TYPE_CHECKING

from zbot.classroom.bundle.errors import BundleError, file_error
from zbot.text.terminal import single_line

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from pathlib import Path

    from zbot.classroom.bundle.resolver import Wheel

_BLOCK = 1 << 18
_AT_ONCE = 4
_TIMEOUT_S = 60.0
_TRIES = 3
PART = ".part"  #: suffix of a file that is not whole yet


def sha256_of(path: Path) -> str:
    """Return the SHA-256 of a file, as hexadecimal digits."""
    digest = hashlib.sha256()
    with path.open("rb") as file:
        while block := file.read(_BLOCK):
            digest.update(block)
    return digest.hexdigest()


def is_whole(path: Path, sha256: str) -> bool:
    """Return whether a file is there and has the given SHA-256."""
    try:
        return sha256_of(path) == sha256
    except OSError:
        return False


def fetch(wheels: Iterable[Wheel], folder: Path, tell: Callable[[str], None]) -> None:
    """Download wheels into a folder, some at the same time.

    Args:
        wheels: The wheels.
        folder: The folder.
        tell: Called with a line after each file.

    Raises:
        BundleError: A wheel cannot be downloaded, or the folder cannot be written.
    """
    wanted = sorted(set(wheels), key=lambda wheel: wheel.name)
    with ThreadPoolExecutor(_AT_ONCE) as pool:
        tasks = {pool.submit(_fetch, wheel, folder): wheel for wheel in wanted}
        try:
            for number, task in enumerate(as_completed(tasks), start=1):
                task.result()
                size = (folder / tasks[task].name).stat().st_size / 1e6
                tell(f"[{number}/{len(wanted)}] {tasks[task].name} ({size:.1f} MB)")
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def _fetch(wheel: Wheel, folder: Path) -> None:
    """Download a wheel. Try again after an error of the network."""
    path = folder / wheel.name
    part = path.with_name(path.name + PART)
    for remaining in reversed(range(_TRIES)):
        try:
            _copy(wheel.url, part)
            break
        except (http.client.HTTPException, OSError) as error:
            _forget(part)
            if _is_of_disk(error) or not remaining:
                raise _download_error(wheel, path, error) from error
    if not is_whole(part, wheel.sha256):
        _forget(part)
        raise BundleError(f"{wheel.name} was changed on its way: its SHA-256 is another one")
    part.replace(path)


def _copy(url: str, part: Path) -> None:
    if not url.startswith(("https:", "http:", "file:")):
        raise BundleError(f"the package index names {single_line(url, 200)!r}, which is no address")
    context = ssl.create_default_context()
    with (
        urllib.request.urlopen(url, timeout=_TIMEOUT_S, context=context) as answer,  # noqa: S310 - as checked
        part.open("wb") as file,
    ):
        while block := answer.read(_BLOCK):
            file.write(block)


def _is_of_disk(error: Exception) -> bool:
    return isinstance(error, OSError) and error.errno in {
        errno.ENOSPC,
        errno.EDQUOT,
        errno.EFBIG,
        errno.EROFS,
        errno.EACCES,
        errno.ENOENT,
        errno.EIO,
    }


def _download_error(wheel: Wheel, path: Path, error: Exception) -> BundleError:
    if isinstance(error, OSError) and _is_of_disk(error):
        return file_error(path, error)
    reason = error.reason if isinstance(error, urllib.error.URLError) else error
    return BundleError(
        f"{wheel.name} cannot be downloaded ({single_line(str(reason), 200)}): "
        "check the internet connection, then type the command again: it goes on where it was"
    )


def _forget(part: Path) -> None:
    with contextlib.suppress(OSError):
        part.unlink()
