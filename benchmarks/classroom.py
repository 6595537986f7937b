"""Measure a class of thirty laptops with five nodes each, all on this machine.

Run: python -m benchmarks.classroom [--laptops 30] [--nodes 5] [--pin] [--netem-minutes 10] [--write]

Needs Linux, root and iproute2 (tests/classroom/testbed.py), and for the full size 8 GB of memory. One
machine does the work of thirty, so work of the processor takes longer than in a real class.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import platform
import statistics
import sys
import time
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zbot
from tests.classroom.impairment import Impairment, impair
from tests.classroom.lesson import Lesson, Node, hub_pid
from tests.classroom.machine import PROGRAMS
from tests.classroom.testbed import LanTestbed, missing_requirement

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from tests.classroom.machine import Machine

PIN = "4711"
IDLE_S = 20.0
ASLEEP_S = 30.0
AWAKE_S = 5.0
FLOOD_S = 60
CUT_S = 30.0
TRIES = 3
HZ = 2.0
RESULTS = Path(__file__).parent / "CLASSROOM.md"


class Report:
    """Table of measured values and their limits; each row is printed at once.

    Each row ends with the load of the machine at that time: other work slows everything down.
    """

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.failures = 0

    def say(self, line: str) -> None:
        print(line, flush=True)
        self.lines.append(line)

    def head(self, title: str) -> None:
        self.say(f"\n## {title}\n")
        self.say("| what | measured | limit | within | load |\n|---|---|---|---|---|")

    def row(self, what: str, measured: float, limit: float | None = None, unit: str = "s") -> None:
        good = limit is None or measured <= limit
        self.failures += not good
        shown = "" if limit is None else f"{limit:g} {unit}"
        verdict = "" if limit is None else "yes" if good else "**no**"
        load = load_average()
        value = f"{measured:.3g}" if measured < 1000 else f"{measured:,.0f}"
        self.say(f"| {what} | {value} {unit} | {shown} | {verdict} | {load:.0f} |")


def load_average() -> float:
    if sys.platform != "linux":
        return math.nan
    return os.getloadavg()[0]


def percentile(values: Sequence[float], share: float) -> float:
    return sorted(values)[int(len(values) * share)]


def resident_mb(pid: int) -> float:
    status = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    return int(status.split("VmRSS:")[1].split()[0]) / 1024


def cpu_s(pid: int) -> float:
    if sys.platform != "linux":
        return math.nan
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


# -- a lesson --------------------------------------------------------------------------------------


def measure_beginning(report: Report, lesson: Lesson) -> None:
    begun = time.monotonic()
    lesson.join()
    joined = time.monotonic() - begun
    report.row("until all laptops have joined, four at a time", joined)
    before = lesson.testbed.teacher.traffic()
    lesson.start_nodes(by_turns=True)
    report.row(
        "from the last node's start until the teacher sees all nodes", lesson.seen_after_s, 10
    )
    carried = lesson.testbed.teacher.traffic() - before
    megabytes = (carried.received_bytes + carried.sent_bytes) / 1e6
    report.row("traffic at the teacher during these starts", megabytes, None, "MB")


def measure_new_nodes(report: Report, lesson: Lesson) -> None:
    after_start: list[float] = []
    after_birth: list[float] = []
    for number in range(10):
        laptop = lesson.testbed.laptops[-1 - number % len(lesson.testbed.laptops)]
        node = (lesson.number_of(laptop), f"/newcomer{number}")
        begun = time.monotonic()
        program = laptop.start("pupil.py", node[1][1:], "pupil0")
        seen = lesson.watch.until(has(node))
        after_start.append(seen - begun)
        after_birth.append(seen - int(program.wait_for("node").split()[1]) / 1e9)
        program.stop(timeout=20)
    report.row("from a node's creation until it is seen, longest of 10", max(after_birth), 0.5)
    report.row(
        "from the start of its process until it is seen, median", statistics.median(after_start)
    )


def has(node: Node) -> Callable[[set[Node]], bool]:
    return lambda nodes: node in nodes


def measure_idle_costs(report: Report, lesson: Lesson) -> None:
    pid = hub_pid(lesson.testbed.teacher)
    before, used = lesson.testbed.teacher.traffic(), cpu_s(pid)
    time.sleep(IDLE_S)
    carried = lesson.testbed.teacher.traffic() - before
    kilobytes = (carried.received_bytes + carried.sent_bytes) / 1000 / IDLE_S
    packets = (carried.received_packets + carried.sent_packets) / IDLE_S
    report.row("idle traffic at the teacher, both ways", kilobytes, 5, "kB/s")
    report.row("idle packets at the teacher, both ways", packets, None, "/s")
    report.row("processor time of the teacher's hub", (cpu_s(pid) - used) / IDLE_S * 100, None, "%")
    report.row("memory of the teacher's hub", resident_mb(pid), None, "MB")
    laptops = [resident_mb(hub_pid(laptop)) for laptop in lesson.testbed.laptops]
    report.row("memory of a laptop's hub, median", statistics.median(laptops), None, "MB")


def measure_losses(report: Report, lesson: Lesson) -> None:
    lost, back = [], []
    for number in range(TRIES):
        laptop = lesson.testbed.laptops[number % len(lesson.testbed.laptops)]
        for cut, repair in (
            (laptop.disconnect, laptop.reconnect),
            (laptop.unplug, laptop.plug_in),
        ):
            gone = time_until_gone(lesson, laptop, cut)
            lost.append(gone)
            back.append(time_until_back(lesson, repair))
    report.row(f"until a lost laptop is shown, longest of {len(lost)}", max(lost), 5)
    report.row(f"from its Wi-Fi's return until it is back, longest of {len(back)}", max(back))


def time_until_gone(lesson: Lesson, laptop: Machine, cut: Callable[[], None]) -> float:
    nodes = lesson.nodes_of(laptop)
    begun = time.monotonic()
    cut()
    return lesson.watch.until(lambda seen: not nodes & seen) - begun


def time_until_back(lesson: Lesson, repair: Callable[[], object]) -> float:
    begun = time.monotonic()
    repair()
    return max(0.0, lesson.watch.until(lesson.all_there, 60) - begun)


def measure_restarts(report: Report, lesson: Lesson) -> None:
    took, opened, carried = [], [], []
    for _ in range(TRIES):
        lesson.kill_hub()
        before, begun = lesson.testbed.teacher.traffic(), time.monotonic()
        lesson.open_class()
        opened.append(time.monotonic() - begun)
        took.append(max(opened[-1], lesson.watch.until(lesson.all_there, 60) - begun))
        traffic = lesson.testbed.teacher.traffic() - before
        carried.append((traffic.received_bytes + traffic.sent_bytes) / 1e6)
    report.row(
        f"from the restart of a killed hub until all are back, longest of {TRIES}", max(took), 3
    )
    report.row("`zbot class start` itself, longest", max(opened))
    report.row("traffic at the teacher during a restart, most", max(carried), None, "MB")


def measure_commands(report: Report, lesson: Lesson) -> None:
    teacher = lesson.testbed.teacher
    listed = teacher.run("zbot", "class", "list", "--json")
    here = sum(len(row["nodes"]) for row in json.loads(listed.out)["students"] if row["here"])
    report.row(f"`zbot class list`, which shows {here} nodes", listed.took_s)
    checked = teacher.run("zbot", "class", "check", "publishes std_msgs/String on /pupil0/words")
    report.row(f"`zbot class check`: {checked.out.splitlines()[-1]}", checked.took_s)
    echoed = teacher.run("zbot", "topic", "echo", "--once", "/1/pupil0/words")
    report.row("`zbot topic echo --once /1/pupil0/words`", echoed.took_s)


def measure_refusals(report: Report, lesson: Lesson, laptop: Machine) -> None:
    code = lesson.code
    typo = code[:-1] + ("2" if code[-1] != "2" else "3")
    report.row("`zbot join` with a wrong code", refusal(laptop, typo, "typo"), 2)
    report.row(
        "`zbot join` if no teacher answers", refusal(laptop, "10.77.200.1", "no machine answers"), 2
    )
    if lesson.has_pin:
        report.row("`zbot join` with a wrong PIN", refusal(laptop, code, "wrong PIN"), 2)
    laptop.block_port(7447)
    report.row("`zbot join` if the port is blocked", refusal(laptop, code, "is blocked"), 2)
    laptop.unblock_ports()


def refusal(laptop: Machine, target: str, words: str) -> float:
    refused = laptop.run("zbot", "join", target, env={"ZBOT_PIN": "4712"})
    assert words in refused.err, refused.err
    return refused.took_s


def measure_flood(report: Report, lesson: Lesson) -> None:
    flooded, other = lesson.testbed.laptops[0], lesson.testbed.laptops[1]
    teacher = lesson.testbed.teacher.start("hear.py", "2/ana/words", "1/flood")
    teacher.wait_for("hearing")
    ana = other.start("pupil.py", "ana", "ana", "--hz", "200")
    ana.wait_for("hears")
    # All laptops share this machine's processor: the flood gets only what the others leave.
    flood = flooded.start("nice", "-n", "19", sys.executable, str(PROGRAMS / "flood.py"))
    flood.wait_for("flood")
    time.sleep(FLOOD_S)
    for program in (flood, ana, teacher):
        program.stop(timeout=20)
    heard = json.loads(teacher.lines[-1])
    # The flood's schedule (flood.py): seconds in which it begins or ends are not counted.
    with_flood, without = (by_second(heard["delays_us"], phase) for phase in (1, 3))
    p99 = [
        percentile([delay for second in part for delay in second], 0.99) / 1000
        for part in (with_flood, without)
    ]
    # Other work only adds delay: the best quarter of the seconds has the least of it.
    better = [
        percentile([percentile(second, 0.99) for second in part], 0.25) / 1000
        for part in (with_flood, without)
    ]
    report.row(
        "messages of the flood that reached the teacher", heard["others"] / FLOOD_S * 2, None, "/s"
    )
    report.row(
        "delay of another student's messages to the teacher, p99, without the flood",
        p99[1],
        None,
        "ms",
    )
    report.row("the same with the flood, p99", p99[0], None, "ms")
    report.row(
        "delay in the best quarter of the seconds, p99, without the flood", better[1], None, "ms"
    )
    report.row(
        "the same with the flood, in percent of the row above",
        better[0] / better[1] * 100,
        120,
        "%",
    )


def by_second(delays_us: dict[str, list[int]], phase: int) -> list[list[int]]:
    whole = (
        delays
        for second, delays in delays_us.items()
        if int(second) % 4 == phase and len(delays) > 100
    )
    return list(whole)


def measure_end(report: Report, lesson: Lesson) -> None:
    heard = lesson.end_nodes()
    delays = [delay for node in heard for delay in node.delays_us]
    report.row("local messages lost in the rows above", sum(node.lost for node in heard), 0, "")
    report.row("local messages received", sum(node.received for node in heard), None, "")
    report.row("delay of local messages, p50", percentile(delays, 0.5) / 1000, None, "ms")
    report.row("delay of local messages, p99", percentile(delays, 0.99) / 1000, None, "ms")


def measure_sleep(report: Report, lesson: Lesson, nodes: int) -> None:
    """Stop all processes of a laptop for a while, with nodes that took no part in the rest.

    The clock of a sleeping laptop stops, but the clock of this machine does not: after the sleep,
    links on 127.0.0.1 have expired. Messages lost by this are local to that laptop.
    """
    laptop = lesson.testbed.laptops[0]
    for position in range(nodes):
        lesson.start_node(laptop, f"pupil{position}", f"pupil{(position + 1) % nodes}")
    lesson.watch.until(lesson.all_there, 60)
    time_until_gone(lesson, laptop, laptop.sleep)
    time.sleep(ASLEEP_S)
    back = time_until_back(lesson, laptop.wake_up)
    report.row(f"until a laptop is back after {ASLEEP_S:.0f} s of sleep", back)
    time.sleep(AWAKE_S)
    lost = sum(node.lost for node in lesson.end_nodes())
    report.row("local messages that it lost because its links expired", lost, None, "")


def hold_lesson(report: Report, options: argparse.Namespace) -> None:
    pin = PIN if options.pin else ""
    report.head(
        f"{options.laptops} laptops with {options.nodes} nodes each, "
        f"{'with' if pin else 'without'} a PIN"
    )
    with LanTestbed(options.laptops + 1) as testbed:
        late = testbed.laptops.pop()
        lesson = Lesson(testbed, options.nodes, pin=pin, hz=HZ)
        measure_beginning(report, lesson)
        measure_new_nodes(report, lesson)
        measure_idle_costs(report, lesson)
        measure_losses(report, lesson)
        measure_restarts(report, lesson)
        measure_commands(report, lesson)
        measure_refusals(report, lesson, late)
        measure_end(report, lesson)
        measure_sleep(report, lesson, options.nodes)
        measure_flood(report, lesson)


# -- bad Wi-Fi -------------------------------------------------------------------------------------


def measure_bad_wifi(report: Report, minutes: float) -> None:
    impairment = Impairment(delay_ms=20, jitter_ms=10, loss=0.02)
    with LanTestbed(1) as testbed:
        lesson, laptop = Lesson(testbed, 1), testbed.laptops[0]
        lesson.join()
        means = impair(testbed, impairment, [laptop])
        report.head(
            f"{minutes:g} minutes with 20 ± 10 ms delay and 2 % loss each way ({means}), and a cut of "
            f"{CUT_S:.0f} s"
        )
        domain = lesson.domain_of(laptop)
        room = testbed.teacher.start("control_room.py", env=domain)
        room.wait_for("receiving")
        telemetry = laptop.start("telemetry.py", env=domain)
        first = int(room.wait_for("first").split()[1])
        watched = {"teacher's hub": hub_pid(testbed.teacher), "laptop's hub": hub_pid(laptop)}
        watched |= {"receiving node": room.process.pid, "sending node": telemetry.process.pid}
        time.sleep(minutes * 60 / 4)
        before = {what: resident_mb(pid) for what, pid in watched.items()}
        time.sleep(minutes * 60 / 4)
        laptop.disconnect()
        time.sleep(CUT_S)
        laptop.reconnect()
        time.sleep(minutes * 60 / 2)
        after = {what: resident_mb(pid) for what, pid in watched.items()}
        telemetry.stop(timeout=20)
        time.sleep(2)
        room.stop(timeout=20)
    for what, pid_before in before.items():
        report.row(f"memory growth of the {what}", after[what] - pid_before, 5, "MB")
    report_numbers(report, first, json.loads(telemetry.lines[-1]), json.loads(room.lines[-1]))


def report_numbers(report: Report, first: int, sent: dict[str, Any], got: dict[str, Any]) -> None:
    report.row("numbers sent (reliable, keep all)", sent["sent"] - first + 1, None, "")
    report.row("numbers received", got["received"], None, "")
    report.row("gaps, including the cut", len(got["gaps"]), 1, "")
    report.row("numbers lost in the cut and reported", got["told_lost"], None, "")
    unknown = sent["sent"] - first + 1 - got["received"] - got["told_lost"]
    report.row("numbers lost and not reported", unknown, 0, "")
    report.row("longest delay of a number", got["slowest_ms"], None, "ms")
    report.row("longest publish()", sent["longest_publish_ms"], None, "ms")
    outcomes = [outcome for _, outcome in sent["calls"]]
    for outcome in dict.fromkeys(outcomes):
        report.row(f"service calls: {outcome}", outcomes.count(outcome), None, "")
    report.row("longest service call (timeout 5 s)", max(took for took, _ in sent["calls"]), 5.5)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--laptops", type=int, default=30)
    parser.add_argument("--nodes", type=int, default=5)
    parser.add_argument("--pin", action="store_true", help="ask for a PIN")
    parser.add_argument("--netem-minutes", type=float, default=0, help="duration of bad Wi-Fi")
    parser.add_argument("--only-netem", action="store_true", help="no lesson")
    parser.add_argument("--write", action="store_true", help="write benchmarks/CLASSROOM.md")
    options = parser.parse_args()
    reason = missing_requirement()
    if reason is not None:
        print(reason, file=sys.stderr)
        return 1
    report = Report()
    report.say("# A classroom, measured\n")
    report.say(
        f"{datetime.now(timezone.utc):%Y-%m-%d}, {platform.system()} {platform.release()} "
        f"{platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}, "
        f"zbot {zbot.__version__}, eclipse-zenoh {version('eclipse-zenoh')}. All laptops are network "
        "namespaces of one machine, on isolated ports and without multicast. `load` is the load "
        "average of this machine, with the processes of the benchmark."
    )
    if not options.only_netem:
        hold_lesson(report, options)
    if options.netem_minutes:
        measure_bad_wifi(report, options.netem_minutes)
    if options.write:
        RESULTS.write_text("\n".join(report.lines) + "\n", encoding="utf-8")
    return 1 if report.failures else 0


if __name__ == "__main__":
    sys.exit(main())
