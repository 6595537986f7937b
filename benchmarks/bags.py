"""Measure recording and playing: losses, memory, CPU time, kills, full disks and timing.

Run: python -m benchmarks.bags [--quick] [--only rates,kills,disk,clock,size,timing]
     make bags ARGUMENTS="--seconds 10 --gigabytes 1"

The options `--seconds` (of recording and of playing), `--kills` and `--gigabytes` set the sizes.
`--quick` has small ones and takes a minute. The whole needs a quiet machine, 10 minutes and 12 GB
of disk. The full disk needs Linux and root. The exit code is 1 if a promise was broken.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import platform
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import psutil

import zbot.bag
from benchmarks.interleaving import percentile
from benchmarks.report import Report

from std_msgs.msg import String, UInt8MultiArray

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

PROGRAM = Path(__file__).parent / "programs" / "bag_program.py"
DOMAIN = "181"
MAX_MEMORY_MB = 700  # the interpreter, Zenoh's queues, and 100 MiB that may wait for the disk
MAX_LATE_MS = 2.0
ROSBAG2_MB_S = 120  #: published for rosbag2: images that it records without losses
_LOST = re.compile(r"(\d+) messages? (?:was|were) lost: (.*)")


@dataclass(frozen=True)
class Extent:
    """How long and how much to measure."""

    seconds: float  #: of recording at each load
    play_seconds: float
    kills: int
    gigabytes: float


QUICK = Extent(5, 5, 5, 0.5)
WHOLE = Extent(60, 30, 50, 5.0)


@dataclass(frozen=True)
class Load:
    """Messages of one program: topics, rate for all together in 1/s, and size in bytes."""

    topics: int
    rate: float
    size: int

    @property
    def text(self) -> str:
        return f"{self.topics} topics, {self.rate:,.0f}/s of {self.size:,} B"


class Bench:
    """Measurements in a folder. Broken promises are counted."""

    def __init__(self, folder: Path, extent: Extent) -> None:
        self.folder, self.extent = folder, extent
        self.report = Report()
        self.failures = 0
        self.env = os.environ | {"ZBOT_DOMAIN_ID": DOMAIN}

    def check(self, holds: bool, text: str) -> str:
        """Return `yes`, or count a broken promise."""
        if not holds:
            self.failures += 1
            self.report.say(f"**broken:** {text}")
        return "yes" if holds else "NO"

    def start(self, *words: str, **options: Any) -> subprocess.Popen[str]:
        return subprocess.Popen(words, env=self.env, cwd=self.folder, text=True, **options)

    def program(self, *words: object) -> subprocess.Popen[str]:
        return self.start(
            sys.executable,
            str(PROGRAM),
            *map(str, words),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )

    @contextlib.contextmanager
    def recorder(self, *words: str, where: Path | None = None) -> Iterator[Recording]:
        path = (where or self.folder) / "bag"
        shutil.rmtree(path, ignore_errors=True)
        log = (self.folder / "log").open("w+")
        process = self.start(
            *(sys.executable, "-m", "zbot_cli", "bag", "record", "-o", str(path), *words),
            stderr=log,
        )
        try:
            yield Recording(process, path, log)
        finally:
            process.kill()
            process.wait()
            log.close()


class Recording:
    """Running `zbot bag record`, and what it used."""

    def __init__(self, process: subprocess.Popen[str], path: Path, log: Any) -> None:
        self.process, self.path, self._log = process, path, log
        self._usage = psutil.Process(process.pid)
        self.memory_mb = 0.0
        self.cpu_s = 0.0

    def output(self) -> str:
        self._log.seek(0)
        return str(self._log.read())

    def wait_for(self, text: str, count: int = 1) -> None:
        deadline = time.monotonic() + 30
        while self.output().count(text) < count:
            if time.monotonic() > deadline or self.process.poll() is not None:
                raise RuntimeError(f"{text!r} never came; there was:\n{self.output()}")
            time.sleep(0.02)

    def watch(self) -> None:
        with contextlib.suppress(psutil.NoSuchProcess):
            times = self._usage.cpu_times()
            self.cpu_s = times.user + times.system
            self.memory_mb = max(self.memory_mb, self._usage.memory_info().rss / 1e6)

    def stop(self) -> None:
        self.process.send_signal(signal.SIGINT)
        while self.process.poll() is None:
            self.watch()
            time.sleep(0.05)

    def lost(self) -> int:
        """Return the losses that the last line about them told."""
        found = _LOST.findall(self.output())
        return int(found[-1][0]) if found else 0


def rates(bench: Bench) -> None:
    """Count messages that are neither in the bag nor said to be lost."""
    seconds = bench.extent.seconds
    bench.report.head(
        f"Recording for {seconds:g} s",
        *("load", "sent", "recorded", "said to be lost", "missing", "recorded data"),
        *("CPU of a core", "memory"),
    )
    images = (Load(1, 30, 1_000_000), Load(10, 10_000, 100))
    for loads in ((Load(10, 10_000, 100),), (Load(10, 100_000, 100),), images):
        senders = [
            bench.program("send", load.topics, load.rate, seconds, load.size) for load in loads
        ]
        names = [name for sender in senders for name in _line(sender)["ready"]]
        with bench.recorder("--topics", *names) as recording:
            recording.wait_for("Subscribed to topic", len(names))
            recording.watch()
            before, begun = recording.cpu_s, time.monotonic()
            for sender in senders:
                _tell(sender)
            while time.monotonic() < begun + seconds:
                recording.watch()
                time.sleep(0.1)
            sent = sum(sum(_line(sender).values()) for sender in senders)
            time.sleep(1)
            recording.watch()
            cpu = (recording.cpu_s - before) / (time.monotonic() - begun)
            recording.stop()
            lost = recording.lost()
        for sender in senders:
            _tell(sender)
            sender.wait(20)
        with zbot.bag.Reader(recording.path) as bag:
            recorded = bag.metadata.message_count
            size_mb = sum(len(message.data) for message in bag.messages()) / 1e6
        missing = sent - recorded - lost
        bench.report.row(
            " and ".join(load.text for load in loads),
            *(f"{sent:,}", f"{recorded:,}", f"{lost:,}", f"{missing:,}"),
            *(f"{size_mb / seconds:.1f} MB/s", f"{cpu:.0%}", f"{recording.memory_mb:.0f} MB"),
        )
        bench.check(missing == 0, f"{missing} messages are missing without a word")
        bench.check(recording.memory_mb < MAX_MEMORY_MB, f"{recording.memory_mb:.0f} MB of memory")


def kills(bench: Bench) -> None:
    """Kill recorders at random moments. What is older than a second must be readable."""
    rounds = bench.extent.kills
    sender = bench.program("send", 1, 1000, 600, 100)
    [name] = _line(sender)["ready"]
    _tell(sender)
    worst, broken = 0.0, 0
    for number in range(rounds):
        form = ("-s", "sqlite3") if number % 5 == 4 else ()
        with bench.recorder("--topics", name, *form) as recording:
            recording.wait_for("Subscribed to topic")
            subscribed = time.time()
            time.sleep(random.uniform(0.6, 2.5))
            killed = time.time()
            recording.process.kill()
            recording.process.wait()
        with zbot.bag.Reader(recording.path) as bag:
            times = [message.log_ns / 1e9 for message in bag.messages()]
            numbers = [int(m.data.split()[0]) for _, m, _ in zbot.bag.read(recording.path)]
        is_whole = (
            numbers == list(range(numbers[0], numbers[0] + len(numbers)))
            if numbers
            else (killed - subscribed < 1)
        )
        lost_s = killed - (times[-1] if times else subscribed)
        worst = max(worst, lost_s)
        broken += not is_whole or lost_s > 1
    sender.kill()
    sender.wait()
    bench.report.head("SIGKILL at random moments", "kills", "lost at most", "bags with gaps")
    bench.report.row(rounds, f"the last {worst:.2f} s", broken)
    bench.check(broken == 0, f"{broken} of {rounds} bags lost more than a second or have gaps")


def disk(bench: Bench) -> None:
    """Fill a small disk. The recorder must say so, and the bag must be readable."""
    if sys.platform != "linux" or os.geteuid():
        bench.report.say("\nThe full disk was not measured: this needs Linux and root.")
        return
    mount = bench.folder / "disk"
    mount.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8m", "tmpfs", str(mount)], check=True)
    sender = bench.program("send", 1, 30, 600, 1_000_000)
    [name] = _line(sender)["ready"]
    try:
        _tell(sender)
        words = ("--topics", name, "--storage-preset-profile", "none")
        with bench.recorder(*words, where=mount) as recording:
            code = recording.process.wait(60)
            said = "No space left on device" in recording.output()
        with zbot.bag.Reader(recording.path) as bag:
            count = sum(1 for _ in bag.messages())
    finally:
        sender.kill()
        sender.wait()
        subprocess.run(["umount", str(mount)], check=True)
    bench.report.head(
        "Full disk of 8 MB", "exit code", "images of 1 MB that can be read", "said so"
    )
    bench.report.row(code, count, bench.check(said and code == 1 and count >= 3, "full disk"))


def clock(bench: Bench) -> None:
    """Write messages while the clock jumps forwards and back. All must be there, in time order."""
    path, day_ns = bench.folder / "clock", 86_400 * 10**9
    jumps = [0, 30 * day_ns, -day_ns, 0, 20_000 * day_ns, 1]
    begun = time.time_ns()
    times = [max(begun + jump + number, 0) for number, jump in enumerate(jumps * 1000)]
    with zbot.bag.Writer(path) as bag:
        for number, t_ns in enumerate(times):
            bag.write("/clock_jumps", String(data=str(number)), t_ns)
    found = [t_ns for _, _, t_ns in zbot.bag.read(path)]
    bench.report.head("Clock that jumps", "messages", "read", "all in the order of their times")
    bench.report.row(len(times), len(found), bench.check(found == sorted(times), "clock jumps"))


def size(bench: Bench) -> None:
    """Write and read a large bag. The memory must stay the same."""
    gigabytes = bench.extent.gigabytes
    own = psutil.Process()
    path = bench.folder / "large"
    block = UInt8MultiArray(data=random.randbytes(1_000_000))
    begun, before = time.monotonic(), own.memory_info().rss
    peak = before
    with zbot.bag.Writer(path, preset="none") as bag:
        for number in range(int(gigabytes * 1000)):
            bag.write("/block", block, number)
            peak = max(peak, own.memory_info().rss)
    written_s = time.monotonic() - begun
    begun, count = time.monotonic(), 0
    for _ in zbot.bag.Reader(path).messages():
        count += 1
        peak = max(peak, own.memory_info().rss)
    read_s = time.monotonic() - begun
    growth_mb = (peak - before) / 1e6
    bench.report.head(
        f"Bag of {gigabytes:g} GB", "messages", "written", "read", "growth of the memory", "rosbag2"
    )
    rates_mb = (f"{gigabytes * 1000 / seconds:.0f} MB/s" for seconds in (written_s, read_s))
    bench.report.row(count, *rates_mb, f"{growth_mb:.0f} MB", f"{ROSBAG2_MB_S} MB/s (published)")
    bench.check(count == int(gigabytes * 1000), "messages of the large bag are missing")
    bench.check(growth_mb < 100, f"the memory grew by {growth_mb:.0f} MB")
    shutil.rmtree(path)


def timing(bench: Bench) -> None:
    """Play 50 topics with 5,000 messages a second, and measure when a subscriber gets them."""
    seconds, topics, rate = bench.extent.play_seconds, 50, 5000
    total = int(seconds * rate)
    path = bench.folder / "timing"
    with zbot.bag.Writer(path) as bag:
        for number in range(total):
            due = number / rate
            bag.write(f"/timing_{number % topics}", String(data=repr(due)), int(due * 1e9) + 1)
    listener = bench.program("listen", topics, seconds + 6)
    _line(listener)
    words = (sys.executable, "-m", "zbot_cli", "bag", "play", str(path))
    bench.start(*words, stderr=subprocess.DEVNULL).wait()
    found = json.loads(_text(listener))
    listener.wait()
    # The middle of all offsets is the unknown time of the start.
    offsets = sorted(heard - planned for planned, heard in found)
    middle = offsets[len(offsets) // 2]
    late = [abs(offset - middle) * 1000 for offset in offsets]
    p50, p99 = percentile(late, 0.5), percentile(late, 0.99)
    bench.report.head(
        "Timing of play, 50 topics, 5,000 messages a second",
        *("messages", "error p50", "p99", "max", "p99 of a plain loop"),
    )
    plain_ms = percentile(_loop_errors(seconds, rate), 0.99)
    bench.report.row(
        *(len(found), f"{p50:.2f} ms", f"{p99:.2f} ms", f"{max(late):.2f} ms"),
        f"{plain_ms:.2f} ms",
    )
    bench.check(len(found) == total, f"{total - len(found)} messages were lost")
    bench.check(p99 <= MAX_LATE_MS, f"the error is {p99:.2f} ms at the 99th percentile")


def _loop_errors(seconds: float, rate: float) -> list[float]:
    """Return how late a loop without messages is, in milliseconds: other work on the machine."""
    errors = []
    start = time.perf_counter()
    for number in range(int(seconds * rate)):
        due = start + number / rate
        while (left := due - time.perf_counter()) > 0:
            time.sleep(left - 0.0008 if left > 0.0008 else 0)
        errors.append(-left * 1000)
    return errors


def _line(program: subprocess.Popen[str]) -> Any:
    return json.loads(_text(program))


def _text(program: subprocess.Popen[str]) -> str:
    assert program.stdout is not None
    return program.stdout.readline()


def _tell(program: subprocess.Popen[str]) -> None:
    assert program.stdin is not None
    program.stdin.write("\n")
    program.stdin.flush()


PARTS = {
    "rates": rates,
    "kills": kills,
    "disk": disk,
    "clock": clock,
    "size": size,
    "timing": timing,
}


def main(words: Sequence[str] | None = None) -> int:
    """Run the measurements. Return 1 if a promise was broken."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", default=",".join(PARTS))
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--kills", type=int)
    parser.add_argument("--gigabytes", type=float)
    options = parser.parse_args(words)
    extent = QUICK if options.quick else WHOLE
    given = {name: getattr(options, name) for name in ("seconds", "kills", "gigabytes")}
    extent = replace(extent, **{name: value for name, value in given.items() if value is not None})
    if options.seconds is not None:
        extent = replace(extent, play_seconds=options.seconds)
    with tempfile.TemporaryDirectory(prefix="zbot-bags-") as folder:
        bench = Bench(Path(folder), extent)
        bench.report.say(
            f"# Bags\n\n{platform.system()} {platform.machine()}, {os.cpu_count()} cores, "
            f"Python {platform.python_version()}, zbot {zbot.__version__}"
        )
        for name in options.only.split(","):
            PARTS[name](bench)
    return int(bench.failures > 0)


if __name__ == "__main__":
    sys.exit(main())
