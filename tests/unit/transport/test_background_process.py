"""Tests of what background processes share."""

from __future__ import annotations

import socket
from typing import TYPE_CHECKING

from zbot.transport import background_process

if TYPE_CHECKING:
    import pytest


def test_machines_with_one_home_folder_have_different_locks(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(socket, "gethostname", lambda: "lab-1")
    first = background_process.lock_path("router-7")
    monkeypatch.setattr(socket, "gethostname", lambda: "lab-2")
    assert first != background_process.lock_path("router-7")
