"""Tests for commands whose output cannot be written, and for faults of the system."""

from __future__ import annotations

import errno
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from zbot_cli.output import standard_streams

if TYPE_CHECKING:
    from tests.cli.conftest import Command

_COMMAND = f"exec '{sys.executable}' -m zbot_cli"
_REFUSED = "cannot write the output: "


@pytest.mark.skipif(sys.platform != "linux", reason="/dev/full is a device of Linux")
@pytest.mark.parametrize(
    ("words", "code", "error"),
    [
        ("--help >/dev/full", 1, f"{_REFUSED}No space left on device\n"),
        ("topic --help >/dev/full", 1, f"{_REFUSED}No space left on device\n"),
        (
            "interface show std_msgs/msg/String >/dev/full",
            1,
            f"{_REFUSED}No space left on device\n",
        ),
        ("--version >&-", 1, f"{_REFUSED}it is closed\n"),
        ("daemon status >&-", 1, f"{_REFUSED}it is closed\n"),
        ("--version 2>&-", 0, ""),
        ("nonsense 2>/dev/full", 1, ""),
        ("interface show no_package/msg/Text 2>/dev/full", 1, ""),
        ("run ./print.py >&-", 0, ""),
        ("run ./print.py <&- 2>&-", 0, ""),
    ],
)
def test_output_that_cannot_be_written_is_one_sentence(
    tmp_path: Path, words: str, code: int, error: str
) -> None:
    (tmp_path / "print.py").write_text("print('hello')\n")
    done = subprocess.run(
        f"{_COMMAND} {words}", shell=True, cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (code, error)


@pytest.mark.parametrize(
    ("error", "sentence"),
    [
        (OSError(errno.EMFILE, "", "x"), "too many files are open: raise the limit"),
        (OSError(errno.EROFS, "", "/some/file"), "cannot use /some/file: Read-only file system"),
        (OSError(errno.EACCES, "", str(Path.home() / ".config")), "hint: set XDG_CONFIG_HOME"),
        (OSError("nothing works"), "the system refused an operation: nothing works"),
    ],
)
@pytest.mark.skipif(sys.platform != "linux", reason="the words and folders are those of Linux")
def test_a_fault_of_the_system_is_one_sentence(
    error: OSError,
    sentence: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delenv("XDG_CONFIG_HOME", raising=False)
    assert standard_streams.report_fault(error) == 1
    assert sentence in capsys.readouterr().err


def test_a_file_that_the_system_refuses_ends_a_command(
    zbot_command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(errno.EACCES, "", "/some/file")

    monkeypatch.setattr("zbot.classroom.machine_state.present_state", refuse)
    refused = zbot_command("status")
    assert (refused.code, refused.out) == (1, "")
    assert refused.err == "cannot use /some/file: Permission denied\n"
