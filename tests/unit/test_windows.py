"""Tests of what can be known about Windows on another system."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import allowed

PROGRAM = str(Path(__file__).with_name("windows_imports.py"))


@pytest.mark.skipif(sys.platform == "win32", reason="the other tests import the modules there")
def test_every_module_loads_without_what_only_posix_has() -> None:
    command = [sys.executable, PROGRAM]
    ended = subprocess.run(
        command, check=False, capture_output=True, text=True, timeout=allowed(120)
    )
    assert ended.returncode == 0, ended.stderr
    assert int(ended.stdout.split()[-2]) > 500
