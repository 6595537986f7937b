"""Tests of what background processes share."""

from __future__ import annotations

import socket
import sys
from types import SimpleNamespace
from typing import TYPE_CHECKING

from zbot.transport import background_process

if TYPE_CHECKING:
    from pathlib import Path

    import pytest


def test_machines_with_one_home_folder_have_different_locks(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(socket, "gethostname", lambda: "lab-1")
    first = background_process.lock_path("router-7")
    monkeypatch.setattr(socket, "gethostname", lambda: "lab-2")
    assert first != background_process.lock_path("router-7")


def test_a_file_that_another_process_has_locked_can_be_read_on_windows(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def refuse(*_: object) -> None:
        raise PermissionError

    path = tmp_path / "program.json"
    path.write_text("a document")
    monkeypatch.setitem(sys.modules, "msvcrt", SimpleNamespace(locking=refuse, LK_NBLCK=2))
    monkeypatch.setattr(sys, "platform", "win32")
    with path.open("r+") as file:
        assert not background_process.lock(file)
        assert file.read() == "a document"
