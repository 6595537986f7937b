"""Tests of the command that installs a package into the environment in use."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

import pytest

from zbot.errors.installation import pip_install

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture
def environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Make an environment, whose Python this process is, and another one on the PATH."""
    if os.name == "nt":
        pytest.skip("Windows finds programs by their ending")
    for name, links in (("own", ["python3", "python3.13"]), ("other", ["python"])):
        (tmp_path / name).mkdir()
        for link in links:
            (tmp_path / name / link).symlink_to(sys.executable)
    monkeypatch.setenv("PATH", str(tmp_path / "other"))
    monkeypatch.setattr(sys, "executable", str(tmp_path / "own" / "python3.13"))
    return tmp_path / "own"


def test_the_python_on_the_path_is_named(
    environment: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(environment))
    assert pip_install("pytest") == "python3 -m pip install pytest"
    (environment / "python").symlink_to(environment / "python3")
    assert pip_install("zbot[bag]") == 'python -m pip install "zbot[bag]"'
    assert pip_install("eclipse-zenoh==1.10.*") == 'python -m pip install "eclipse-zenoh==1.10.*"'


def test_a_python_that_is_not_on_the_path_is_named_with_its_path(environment: Path) -> None:
    assert pip_install("pytest") == f"{environment}/python3.13 -m pip install pytest"
