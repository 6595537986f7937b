"""Tests of the processes that a launch starts."""

from __future__ import annotations

import asyncio
import subprocess
import sys

import pytest

from zbot.launch import process
from zbot.launch.process_group import ProcessGroups

MASK = "import signal; print(signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, []))"


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.parametrize("is_zbot", [True, False])
def test_only_commands_of_zbot_start_with_ctrl_c_blocked(
    monkeypatch: pytest.MonkeyPatch, *, is_zbot: bool
) -> None:
    monkeypatch.setattr(process, "zbot_command", lambda: [sys.executable] if is_zbot else ["zbot"])
    output: list[bytes] = []

    async def run() -> int:
        groups = ProcessGroups()
        child = await process.start(
            [sys.executable, "-c", MASK],
            env={},
            cwd=None,
            has_terminal=False,
            stdin=subprocess.DEVNULL,
            on_data=lambda _, data: output.append(data),
            process_groups=groups,
        )
        try:
            return await child.wait()
        finally:
            groups.close()

    assert asyncio.run(run()) == 0
    assert b"".join(output).decode().split() == [str(is_zbot)]
