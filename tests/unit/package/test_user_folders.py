"""Tests of the folders of the user, on a machine that has other users."""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from zbot.package.user_folders import cache_folder, home_folder, make_private

if TYPE_CHECKING:
    from collections.abc import Iterator

needs_modes = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such modes")


@pytest.fixture
def no_umask() -> Iterator[None]:
    before = os.umask(0)
    yield
    os.umask(before)


@needs_modes
@pytest.mark.usefixtures("no_umask")
def test_new_folders_are_private_whatever_the_umask(tmp_path: Path) -> None:
    folder = tmp_path / "a" / "b" / "c"
    make_private(folder)
    make_private(folder)
    assert [oct(place.stat().st_mode)[-3:] for place in (folder, *folder.parents)][:3] == [
        "700"
    ] * 3


@needs_modes
def test_a_folder_that_exists_keeps_its_mode(tmp_path: Path) -> None:
    tmp_path.chmod(0o755)
    make_private(tmp_path / "new")
    make_private(tmp_path)
    assert tmp_path.stat().st_mode & 0o777 == 0o755


@needs_modes
def test_a_file_in_the_way_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("")
    with pytest.raises(OSError, match="a"):
        make_private(tmp_path / "a" / "b")


@pytest.mark.parametrize(
    ("platform", "folder"),
    [("linux", "cache/zbot"), ("darwin", "Library/Caches/zbot"), ("win32", "local/zbot")],
)
def test_each_system_has_its_own_cache_folder(
    platform: str, folder: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "local"))
    assert cache_folder() == tmp_path / folder


@pytest.mark.skipif(sys.platform == "win32", reason="the folder has another name there")
def test_a_user_without_a_home_gets_a_folder_among_the_temporary_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_home() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(Path, "home", no_home)
    folder = tmp_path / f"zbot-{os.getuid()}"
    assert home_folder() == folder
    assert folder.stat().st_mode & 0o777 == 0o700
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    (tmp_path / "zbot-12345").mkdir()
    with pytest.raises(PermissionError, match="belongs to another user"):
        home_folder()


@pytest.mark.skipif(sys.platform == "win32", reason="the folder has another name there")
def test_a_cache_that_cannot_be_written_is_among_the_temporary_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setenv("HOME", str(tmp_path / "missing"))
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(os, "access", lambda path, _: path != tmp_path)
    assert cache_folder() == tmp_path / f"zbot-{os.getuid()}"


@pytest.mark.skipif(
    sys.platform == "win32" or os.getuid() != 0, reason="only root can give it away"
)
def test_a_temporary_folder_of_another_user_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(Path, "home", _no_home)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    theirs = tmp_path / f"zbot-{os.getuid()}"
    theirs.mkdir()
    os.chown(theirs, 12345, 12345)
    with pytest.raises(PermissionError, match="it belongs to another user"):
        cache_folder()


def _no_home() -> Path:
    raise RuntimeError
