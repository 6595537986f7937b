"""Folders in which zbot keeps what belongs to the user: settings, added definitions, caches."""

from __future__ import annotations

import contextlib
import errno
import os
import sys
from pathlib import Path


def make_private(folder: Path) -> None:
    """Make a folder, and its missing parents, which only this user can read and change.

    Its mode does not depend on the umask. A folder that exists stays as it is.

    Raises:
        OSError: The folder cannot be made.
    """
    if not folder.is_dir():
        make_private(folder.parent)
        with contextlib.suppress(FileExistsError):  # another program was faster
            folder.mkdir(mode=0o700)


def home_folder() -> Path:
    """Return the user's home folder.

    A user without one, e.g. in a container, gets a folder of this user among the temporary files.
    """
    try:
        return Path.home()
    except RuntimeError:
        return _temporary_folder()


def settings_folder() -> Path:
    """Return the folder for the user's own settings. The folder may not exist yet.

    It is `$XDG_CONFIG_HOME/zbot` if that variable is set. Otherwise it is `~/.config/zbot`, or on
    macOS `~/Library/Application Support/zbot`, or on Windows `%APPDATA%/zbot`.
    """
    base = os.environ.get("XDG_CONFIG_HOME")
    if base:
        return Path(base) / "zbot"
    if sys.platform == "win32":
        return Path(os.environ.get("APPDATA") or home_folder() / "AppData" / "Roaming") / "zbot"
    if sys.platform == "darwin":
        return home_folder() / "Library" / "Application Support" / "zbot"
    return home_folder() / ".config" / "zbot"


def definitions_folder() -> Path:
    """Return the folder with the definitions that `zbot interface add` has copied, by package.

    The folder may not exist.
    """
    return settings_folder() / "interfaces"


def cache_folder() -> Path:
    """Return the user's cache folder for zbot.

    If the user has no home folder that can be written, e.g. as the user of a service, it is a
    folder of this user among the temporary files.
    """
    folder = _usual_cache_folder()
    return folder if _can_be_written(folder) else _temporary_folder()


def _can_be_written(folder: Path) -> bool:
    above = (folder, *folder.parents)
    present = next((place for place in above if os.path.exists(place)), folder)  # noqa: PTH110 - raises no PermissionError
    return os.access(present, os.W_OK)


def _temporary_folder() -> Path:
    import tempfile  # noqa: PLC0415 - few users have no home folder

    if sys.platform == "win32":
        return Path(tempfile.gettempdir()) / "zbot"  # each user has a folder of temporary files
    folder = Path(tempfile.gettempdir()) / f"zbot-{os.getuid()}"
    with contextlib.suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    if folder.lstat().st_uid != os.getuid():  # another user could change the programs in it
        raise PermissionError(errno.EPERM, "it belongs to another user", str(folder))
    return folder


def _usual_cache_folder() -> Path:
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA") or home_folder() / "AppData" / "Local"
    elif sys.platform == "darwin":
        base = home_folder() / "Library" / "Caches"
    else:
        base = os.environ.get("XDG_CACHE_HOME") or home_folder() / ".cache"
    return Path(base).expanduser() / "zbot"
