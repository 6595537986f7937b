from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest

from zbot.transport.process_state import is_stopped


@pytest.mark.skipif(sys.platform == "win32", reason="Windows cannot stop a process")
def test_a_process_is_stopped_until_it_continues() -> None:
    with subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE) as process:
        assert not is_stopped(process.pid)
        process.send_signal(signal.SIGSTOP)
        os.waitpid(process.pid, os.WUNTRACED)
        assert is_stopped(process.pid)
        process.send_signal(signal.SIGCONT)
        process.communicate(b"")
    assert not is_stopped(process.pid)
