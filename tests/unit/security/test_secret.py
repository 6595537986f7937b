from __future__ import annotations

import os
import pickle
import stat
from typing import TYPE_CHECKING

import pytest

from zbot.security.secret import Secret, make_private_folder, write_private

if TYPE_CHECKING:
    from pathlib import Path


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


def test_a_secret_is_shown_only_by_reveal() -> None:
    secret = Secret("4711")
    shown = f"{secret} {secret!r} {[secret]} {secret!s}"
    assert "4711" not in shown
    assert secret.reveal() == "4711"


def test_a_secret_is_in_no_pickle() -> None:
    with pytest.raises(TypeError, match="cannot pickle a Secret"):
        pickle.dumps(Secret("4711"))


def test_secrets_compare_by_their_text() -> None:
    assert Secret("4711") == Secret("4711")
    assert Secret("4711") != Secret("4712")
    assert Secret("4711") != "4711"
    assert len({Secret("4711"), Secret("4711")}) == 1


def test_random_secrets_differ_and_are_long() -> None:
    found = {Secret.random().reveal() for _ in range(100)}
    assert len(found) == 100
    assert {len(text) for text in found} == {32}


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file modes")
def test_private_files_and_folders_are_for_their_owner_only(tmp_path: Path) -> None:
    folder = tmp_path / "above" / "folder"
    make_private_folder(folder)
    write_private(folder / "file", b"x")
    assert mode(folder) == 0o700
    assert mode(folder.parent) in {0o700, 0o755}
    assert mode(folder / "file") == 0o600


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file modes")
def test_an_existing_file_is_made_private_when_it_is_replaced(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"old")
    path.chmod(0o644)
    write_private(path, b"new")
    assert mode(path) == 0o600
    assert path.read_bytes() == b"new"


def test_a_failed_write_leaves_the_old_file_and_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"old")

    def fail(_descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(OSError, match="No space"):
        write_private(path, b"new")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]
