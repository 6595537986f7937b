"""Fixtures for packages in a workspace around the current folder."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

MANIFEST = "<package><name>{}</name></package>"
SETUP = "from glob import glob\nname = 'robot'\nsetup(name=name, data_files=[{}])\n"


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Path]:
    """Return a function that writes a package into a workspace around the current folder."""
    source = tmp_path / "ws" / "src"
    source.mkdir(parents=True)
    monkeypatch.chdir(source.parent)

    def make(*files: str, name: str = "robot", setup: str = "", cmake: str = "") -> Path:
        folder = source / name
        for file in files:
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_text(file)
        folder.mkdir(exist_ok=True)
        (folder / "package.xml").write_text(MANIFEST.format(name))
        if setup:
            (folder / "setup.py").write_text(SETUP.format(setup))
        if cmake:
            (folder / "CMakeLists.txt").write_text(cmake)
        return folder

    return make
