"""Tests of the environment of a launch."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.launch import LaunchContext
from zbot.launch.actions import (
    PopEnvironment,
    PushEnvironment,
    ResetEnvironment,
    SetEnvironmentVariable,
    UnsetEnvironmentVariable,
)
from zbot.launch.python_file import load_module
from zbot.package.finder import Origin, find_package

if TYPE_CHECKING:
    import pytest


def test_the_end_of_a_launch_takes_back_only_its_own_changes() -> None:
    os.environ.update({"KEPT": "a", "CHANGED": "a", "REMOVED": "a"})
    context = LaunchContext()
    SetEnvironmentVariable("CHANGED", "b").visit(context)
    SetEnvironmentVariable("CHANGED", "c").visit(context)
    SetEnvironmentVariable("NEW", "b").visit(context)
    UnsetEnvironmentVariable("REMOVED").visit(context)
    os.environ["KEPT"] = "b"
    assert (os.environ["CHANGED"], os.environ["NEW"]) == ("c", "b")
    assert "REMOVED" not in os.environ
    context.close()
    assert (os.environ["CHANGED"], os.environ["REMOVED"], os.environ["KEPT"]) == ("a", "a", "b")
    assert "NEW" not in os.environ
    os.environ["CHANGED"] = "d"
    context.close()
    assert os.environ["CHANGED"] == "d"


def test_a_scope_and_a_reset_restore_the_environment() -> None:
    context = LaunchContext()
    SetEnvironmentVariable("COLOUR", "red").visit(context)
    PushEnvironment().visit(context)
    SetEnvironmentVariable("COLOUR", "blue").visit(context)
    PopEnvironment().visit(context)
    assert os.environ["COLOUR"] == "red"
    ResetEnvironment().visit(context)
    assert "COLOUR" not in os.environ


def test_a_launch_file_that_uses_the_prefixes_finds_its_own_package_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("arm", "wheels"):
        folder = tmp_path / "src" / name
        (folder / "launch").mkdir(parents=True)
        (folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
        text = 'import os\nPREFIXES = os.getenv("AMENT_PREFIX_PATH").split(os.pathsep)\n'
        (folder / "launch" / "a.launch.py").write_text(text)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    for first, second in (("arm", "wheels"), ("wheels", "arm")):
        monkeypatch.delenv("AMENT_PREFIX_PATH", raising=False)
        module = load_module(tmp_path / "src" / first / "launch" / "a.launch.py")
        for prefix, name in zip(module.PREFIXES, (first, second), strict=True):
            assert Path(prefix, "share", name, "package.xml").is_file()
    found = find_package("arm")
    assert found is not None
    assert found.origin is Origin.WORKSPACE
    monkeypatch.chdir("/")
    assert find_package("arm") is None  # what zbot makes is no second place of a package
