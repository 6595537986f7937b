"""Chaos run: `python -m tests.torture.chaos --minutes 60`.

Programs are killed, stopped, continued, cut off and delayed at random. Clocks jump, a disk is full,
descriptors run out, hubs are killed. Meanwhile an observer checks what zbot promises. The seed is
printed: the same seed makes the same faults at the same times. Needs Linux; root for the class and
for the full disk, and a C compiler for the clocks.
"""

from __future__ import annotations

import argparse
import secrets
import sys
import tempfile
import threading
from pathlib import Path

from tests.torture.class_chaos import run_class
from tests.torture.domain_chaos import DomainChaos, small_disk
from tests.torture.processes import Processes, clean_end
from tests.torture.report import Report
from tests.torture.stall import StallMeter
from zbot.testing.domain import reserved_domain


def run_domain(folder: Path, seed: str, seconds: float, report: Report, stall: StallMeter) -> None:
    """Run the chaos in a domain."""
    with (
        reserved_domain() as domain,
        Processes(folder, domain) as processes,
        small_disk(processes.settings) as has_disk,
    ):
        DomainChaos(processes, seed, seconds, report, stall, has_disk=has_disk).run()


def main() -> int:
    parser = argparse.ArgumentParser(description="Chaos in a domain and in a class.")
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--seed", default="", help="text; the same seed makes the same faults")
    parser.add_argument("--only", choices=("domain", "class"), help="by default both, in turn")
    given = parser.parse_args()
    seed = given.seed or secrets.token_hex(4)
    print(f"seed {seed}, {given.minutes:g} minutes", flush=True)
    folder = Path(tempfile.mkdtemp(prefix="zbot-chaos-"))
    report = Report()
    places = [given.only] if given.only else ["domain", "class"]
    seconds = 60 * given.minutes / len(places)
    with clean_end(), StallMeter() as stall, report.until_interrupted():
        for place in places:
            run = run_domain if place == "domain" else run_class
            (folder / place).mkdir()
            run(folder / place, seed, seconds, report, stall)
    only = f" --only {given.only}" if given.only else ""
    again = f"python -m tests.torture.chaos --seed {seed} --minutes {given.minutes:g}{only}"
    code = report.end(again, folder, stall)
    threads = [thread.name for thread in threading.enumerate() if not thread.daemon]
    assert threads == ["MainThread"], threads
    return code


if __name__ == "__main__":
    sys.exit(main())
