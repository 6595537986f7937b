"""CPU time that other programs use beside a measurement, and waiting for its end.

Only Linux tells the CPU time of all programs. Elsewhere, other programs are not noticed.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

_LOOK_S = 0.5
_ROUNDING_S = 0.04  # the kernel counts in steps of 0.01 s, for each core and each kind


class OtherLoad:
    """Average number of cores that other programs use, from now on.

    Programs that this process has started and has waited for are not other programs. Time that
    a virtual machine did not get counts as used by others.
    """

    def __init__(self) -> None:
        self._begun = time.monotonic()
        self._before_s = _others_s()

    def cores(self) -> float:
        used_s = _others_s() - self._before_s - _ROUNDING_S
        return max(0.0, used_s) / (time.monotonic() - self._begun)


def wait_for_quiet(cores: float, timeout_s: float) -> None:
    """Wait until other programs use less than a number of cores, or until the time is over."""
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        load = OtherLoad()
        time.sleep(_LOOK_S)
        if load.cores() < cores:
            return


def _others_s() -> float:
    if sys.platform != "linux":
        return 0.0
    line = Path("/proc/stat").read_text(encoding="ascii").partition("\n")[0]
    # man 5 proc_stat: user, nice, system, idle, iowait, irq, softirq, steal
    ticks = [int(word) for word in line.split()[1:9]]
    busy = sum(ticks) - sum(ticks[3:5])
    return busy / os.sysconf("SC_CLK_TCK") - sum(os.times()[:4])
