"""Folders in which zbot keeps what belongs to the user: settings, added definitions, caches."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def settings_folder() -> Path:
    """Return the folder for the user's own settings. The folder may not exist yet.

    It is `$XDG_CONFIG_HOME/zbot` if that variable is set. Otherwise it is `~/.config/zbot`, or on
    macOS `~/Library/Application Support/zbot`, or on Windows `%APPDATA%/zbot`.
    """
    base = os.environ.get("XDG_CONFIG_HOME")
    if base:
        return Path(base) / "zbot"
    if sys.platform == "win32":
        return Path(os.environ.get("APPDATA") or Path.home() / "AppData" / "Roaming") / "zbot"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "zbot"
    return Path.home() / ".config" / "zbot"


def definitions_folder() -> Path | None:
    """Return the folder with the definitions that `zbot interface add` has copied, by package.

    The folder may not exist. The result is None if the user has no home folder.
    """
    try:
        return settings_folder() / "interfaces"
    except RuntimeError:  # there is no home folder, e.g. in a container
        return None


def cache_folder() -> Path:
    """Return the user's cache folder for zbot."""
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA") or "~/AppData/Local"
    elif sys.platform == "darwin":
        base = "~/Library/Caches"
    else:
        base = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    return Path(base).expanduser() / "zbot"
