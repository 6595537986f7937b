"""Scripts in `install/` that make a workspace's packages known in every folder, as in ROS 2.

Lessons for ROS 2 tell students to type `source install/setup.bash` after a build. The scripts add
the workspace to ZBOT_WORKSPACE.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

_MARK = "Written by `zbot build`"
_SHELL = """\
# {mark}. It makes the packages of this workspace known in every folder.
for _zbot_workspace in {folders}; do
    case ":${{ZBOT_WORKSPACE-}}:" in
        *":$_zbot_workspace:"*) ;;
        *) export ZBOT_WORKSPACE="$_zbot_workspace${{ZBOT_WORKSPACE:+:$ZBOT_WORKSPACE}}" ;;
    esac
done
unset _zbot_workspace
"""
_POWERSHELL = """\
# {mark}. It makes the packages of this workspace known in every folder.
foreach ($zbotWorkspace in {folders}) {{
    $zbotKnown = @($env:ZBOT_WORKSPACE -split [IO.Path]::PathSeparator | Where-Object {{ $_ }})
    if ($zbotKnown -notcontains $zbotWorkspace) {{
        $env:ZBOT_WORKSPACE = (@($zbotWorkspace) + $zbotKnown) -join [IO.Path]::PathSeparator
    }}
}}
"""
_BATCH = """\
@rem {mark}. It makes the packages of this workspace known in every folder.
@for %%i in ({folders}) do @call :zbot_add "%%~i"
@exit /b 0
:zbot_add
@echo ";%ZBOT_WORKSPACE%;" | find /i ";%~1;" >nul && exit /b 0
@if defined ZBOT_WORKSPACE (set "ZBOT_WORKSPACE=%~1;%ZBOT_WORKSPACE%") else set "ZBOT_WORKSPACE=%~1"
@exit /b 0
"""
#: For each ending of a script: its text, the escaped form of `'`, the quotation mark around a path,
#: and the separator of paths.
_KINDS = {
    "bash": (_SHELL, "'\\''", "'", " "),
    "zsh": (_SHELL, "'\\''", "'", " "),
    "sh": (_SHELL, "'\\''", "'", " "),
    "ps1": (_POWERSHELL, "''", "'", ", "),
    "bat": (_BATCH, "'", '"', " "),
}


def install_folder_error(folder: Path, reason: str) -> CommandError:
    """Return the error that the scripts of a workspace cannot be written."""
    hint = "the packages run without it: go to their workspace and use `zbot run`"
    return CommandError(f"cannot write {folder}: {reason}", hint=hint)


def write_setup_scripts(install: Path, folders: Sequence[Path]) -> bool:
    """Write `setup.bash`, `local_setup.bash` and the scripts of other shells.

    Args:
        install: The folder for the scripts.
        folders: The folders to add to ZBOT_WORKSPACE.

    Returns:
        True if the scripts were written. False if the folder belongs to a real `colcon build`.

    Raises:
        CommandError: A file cannot be written.
    """
    if not _is_ours(install):
        return False
    try:
        install.mkdir(exist_ok=True)
        for ending in _KINDS:
            for name in ("setup", "local_setup"):
                _write(install / f"{name}.{ending}", _text(ending, folders))
    except OSError as exc:
        raise install_folder_error(install, exc.strerror or str(exc)) from exc
    return True


def source_line() -> str:
    """Return the line that a user of this system types after a build."""
    return r"install\setup.ps1" if os.name == "nt" else "source install/setup.bash"


def _is_ours(install: Path) -> bool:
    if not install.exists():
        return True
    try:
        return _MARK in (install / "setup.bash").read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return install.is_dir() and not any(install.iterdir())


def _text(ending: str, folders: Sequence[Path]) -> str:
    template, escaped, quote, between = _KINDS[ending]
    quoted = (f"{quote}{str(folder).replace(chr(39), escaped)}{quote}" for folder in folders)
    return template.format(mark=_MARK, folders=between.join(quoted))


def _write(path: Path, text: str) -> None:
    # Windows PowerShell reads a script as UTF-8 only if it begins with a byte order mark.
    encoding = "utf-8-sig" if path.suffix == ".ps1" else "utf-8"
    newline = "\r\n" if path.suffix == ".bat" else "\n"
    path.write_text(text, encoding=encoding, newline=newline)
