"""Files of a user on a machine that has other users."""

from __future__ import annotations

import os
import stat
import sys
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start

NODE = """
import os

os.umask(0)
import zbot

zbot.init()
node = zbot.Node("a")
print("ready", flush=True)
zbot.spin(node)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such modes")
def test_others_can_change_nothing_whatever_the_umask(
    start: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = tmp_path / "new" / "settings"
    monkeypatch.setenv("XDG_CONFIG_HOME", str(settings))
    program = start(source=NODE)
    program.wait_for("ready")
    found = [path for path in (tmp_path / "new").rglob("*") if not path.is_symlink()]
    assert any(path.name.endswith(".lock") for path in found)
    folders = [path for path in (tmp_path / "new", *found) if path.is_dir()]
    assert {oct(stat.S_IMODE(path.stat().st_mode)) for path in folders} == {"0o700"}
    assert all(path.stat().st_uid == os.getuid() for path in found)
