"""Tests of the name of the space in which process ids and ports mean the same."""

from __future__ import annotations

import os
import socket
import sys
from typing import TYPE_CHECKING

import pytest

from zbot.transport import background_process, membership, process_facts

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has namespaces")


@pytest.fixture
def machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with the files that tell the space."""
    for name in ("boot", "net", "pid"):
        (tmp_path / name).write_text("a", encoding="utf-8")
    monkeypatch.setattr(process_facts, "_BOOT", tmp_path / "boot")
    monkeypatch.setattr(process_facts, "_NAMESPACES", tmp_path)
    monkeypatch.setattr(socket, "gethostname", lambda: "lab")
    return tmp_path


def test_the_space_is_the_same_for_all_programs_of_a_machine(machine: Path) -> None:
    name = process_facts.process_space()
    assert name.startswith("lab-")
    assert name == process_facts.process_space()
    assert machine.is_dir()


@pytest.mark.parametrize("changed", ["boot", "net", "pid"])
def test_each_boot_and_each_namespace_is_another_space(machine: Path, changed: str) -> None:
    before = process_facts.process_space()
    (machine / "kept").write_text("a", encoding="utf-8")  # so that the new file has another inode
    (machine / changed).rename(machine / "old")
    (machine / changed).write_text("b", encoding="utf-8")
    assert process_facts.process_space() != before


def test_a_process_that_cannot_see_its_namespaces_is_alone(machine: Path) -> None:
    (machine / "net").unlink()
    alone = process_facts.process_space()
    read, write = os.pipe()
    child = os.fork()
    if not child:
        os.write(write, process_facts.process_space().encode())
        os._exit(0)
    os.waitpid(child, 0)
    assert os.read(read, 100).decode() != alone
    os.close(read)
    os.close(write)


def test_only_lock_files_that_nobody_has_used_for_a_week_are_removed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    folder = membership.folder()
    folder.mkdir()
    host = socket.gethostname()
    names = {"old": f"router-1@{host}-1.lock", "used": f"router-2@{host}-1.lock"}
    names |= {"new": f"router-3@{host}-1.lock", "foreign": "router-1@elsewhere-1.lock"}
    for name in names.values():
        (folder / name).touch()
    for name in ("old", "used", "foreign"):
        os.utime(folder / names[name], (0, 0))
    with (folder / names["used"]).open("r+", encoding="utf-8") as file:
        assert background_process.lock(file)
        background_process.remove_old_locks()
    assert {path.name for path in folder.iterdir()} == set(names.values()) - {names["old"]}
