"""Process that does nothing until the launch ends."""

from __future__ import annotations

import sys

from zbot.launch.actions.execute import ExecuteProcess

_WAIT = "import signal, sys, threading\nsignal.signal(signal.SIGINT, lambda *_: sys.exit(0))\n"


class KeepAliveProc(ExecuteProcess):
    """Keeps a launch running, even if the launch has nothing else to wait for."""

    def __init__(self) -> None:
        super().__init__(cmd=[sys.executable, "-c", f"{_WAIT}threading.Event().wait()"])
