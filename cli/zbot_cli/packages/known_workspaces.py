"""List of the workspaces in which this user has worked.

If a package is not found, the error uses this list to say which workspace has the package.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.package.user_folders import make_private
from zbot.package.workspace import package_folders, package_name
from zbot.text.json_reader import read_json
from zbot.transport.membership import folder as settings_folder

if TYPE_CHECKING:
    from zbot.package.workspace import Roots

_FILE = "workspaces.json"
_MAX = 20


def workspace_folder(roots: Roots) -> Path:
    """Return the folder that contains `src`. Without `src`, return the first folder of `roots`."""
    first = roots[0][0]
    return first.parent if first.name == "src" else first


def remember(roots: Roots) -> None:
    """Put a workspace at the start of the list. Do nothing if the list cannot be written."""
    if not roots:
        return
    known = _known()
    workspace = str(workspace_folder(roots))
    changed = [workspace, *(folder for folder in known if folder != workspace)][:_MAX]
    if changed == known:
        return
    file = settings_folder() / _FILE
    try:
        make_private(file.parent)
        file.write_text(json.dumps(changed), encoding="utf-8")
    except OSError:
        return  # the list only makes errors more helpful


def workspace_of(package: str) -> Path | None:
    """Return the workspace in the list that has a package, or None if there is none."""
    for workspace in map(Path, _known()):
        source = workspace / "src"
        for folder in package_folders([source if source.is_dir() else workspace]):
            if package_name(folder) == package:
                return workspace
    return None


def folder_below(package: str) -> Path | None:
    """Return the package's folder below the current one, where programs do not search."""
    try:
        found = package_folders([Path.cwd()])
    except FileNotFoundError:
        return None  # the current folder was deleted
    return next((folder for folder in found if package_name(folder) == package), None)


def _known() -> list[str]:
    try:
        found = read_json((settings_folder() / _FILE).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return []
    return (
        [folder for folder in found if isinstance(folder, str)] if isinstance(found, list) else []
    )
