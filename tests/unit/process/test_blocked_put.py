"""Search for blocked puts while threads start and end."""

from __future__ import annotations

import subprocess
import sys

BUSY = """
import _thread, gc, sys, threading, time
from zbot.process import blocked_put

class Waste:
    def __init__(self):
        self.itself = self

    def __del__(self):
        time.sleep(0)  # lets the other threads run

def start_threads():
    while True:
        _thread.start_new_thread(int, ())
        time.sleep(0.0002)

blocked_put.watch_signals()
for _ in range(20):  # the search creates an object for each
    threading.Thread(target=threading.Event().wait, daemon=True).start()
threading.Thread(target=start_threads, daemon=True).start()
gc.set_threshold(10, 1, 1)
sys.setswitchinterval(1e-5)
for _ in range(2000):
    Waste()
    blocked_put.cancel_all([])
print("looked")
"""


def test_ending_threads_and_garbage_collection_do_not_block_the_search() -> None:
    # Python 3.11 would deadlock (cpython issue 106883).
    command = [sys.executable, "-c", BUSY]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=20)
    assert (done.stdout, done.stderr) == ("looked\n", "")
