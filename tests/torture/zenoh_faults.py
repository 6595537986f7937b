"""Faults of Zenoh: `python -m tests.torture.zenoh_faults` says which of them are still there.

docs/design/zenoh-faults.md describes the faults. Run this after each update of eclipse-zenoh.
"""

from __future__ import annotations

import subprocess
import sys
from importlib.metadata import version

from tests.torture.processes import PROGRAMS

_TIMEOUT_S = 120


def main() -> int:
    print(f"eclipse-zenoh {version('eclipse-zenoh')}", flush=True)
    for path in sorted((PROGRAMS / "zenoh_faults").glob("*.py")):
        try:
            words = [sys.executable, str(path)]
            done = subprocess.run(
                words, capture_output=True, text=True, timeout=_TIMEOUT_S, check=False
            )
        except subprocess.TimeoutExpired:
            print(f"{path.stem}: no end after {_TIMEOUT_S} s", flush=True)
            continue
        state = {0: "gone", 1: "still there"}.get(done.returncode, f"exit code {done.returncode}")
        print(f"{path.stem}: {state}: {' '.join(done.stdout.split())}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
