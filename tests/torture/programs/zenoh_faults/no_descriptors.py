"""Fault of Zenoh 1.10: without free descriptors, opening a session panics or aborts the process.

Run: no_descriptors.py
"""

from __future__ import annotations

import os
import subprocess
import sys

_SOURCE = """
import json, os, resource, zenoh
limit = int(os.environ["LIMIT"])
resource.setrlimit(resource.RLIMIT_NOFILE, (limit, limit))
config = zenoh.Config()
config.insert_json5("listen/endpoints", json.dumps(["tcp/127.0.0.1:0"]))
try:
    zenoh.open(config).close()
except zenoh.ZError:
    pass  # an error that a program can handle
"""


def main() -> int:
    ends = {}
    for limit in range(6, 24):
        done = subprocess.run(
            [sys.executable, "-c", _SOURCE],
            env={**os.environ, "LIMIT": str(limit)},
            capture_output=True,
            timeout=30,
            check=False,
        )
        ends[limit] = done.returncode
    panics = [limit for limit, code in ends.items() if code == 1]
    aborts = [limit for limit, code in ends.items() if code < 0]
    print(f"panics with a limit of {panics} descriptors, and aborts with {aborts}")
    return 1 if panics or aborts else 0


if __name__ == "__main__":
    sys.exit(main())
