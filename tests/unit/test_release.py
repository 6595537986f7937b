"""Tests of the check before a release."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from zbot.version import __version__

ROOT = Path(__file__).parents[2]


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """Return a folder with the files that the check reads, ready for a release."""
    for name in (".ci/release", "zbot/version.py"):
        (tmp_path / name).parent.mkdir()
        (tmp_path / name).write_bytes((ROOT / name).read_bytes())
    (tmp_path / "CHANGELOG.md").write_text(f"# Changelog\n\n## {__version__} (2026-12-01)\n")
    return tmp_path


def check(checkout: Path, tag: str) -> tuple[int, str]:
    words = [sys.executable, str(checkout / ".ci" / "release"), tag]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return done.returncode, done.stderr


def test_a_dated_version_can_be_released(checkout: Path) -> None:
    assert check(checkout, f"v{__version__}") == (0, "")


def test_another_tag_is_refused(checkout: Path) -> None:
    code, text = check(checkout, "v99.0")
    assert code == 1
    assert text == f"zbot/version.py has the version {__version__}, but the tag is v99.0\n"


def test_a_version_without_a_date_is_refused(checkout: Path) -> None:
    (checkout / "CHANGELOG.md").write_text(f"## {__version__} (not released yet)\n")
    code, text = check(checkout, f"v{__version__}")
    assert code == 1
    assert text.startswith("CHANGELOG.md must begin with ")
