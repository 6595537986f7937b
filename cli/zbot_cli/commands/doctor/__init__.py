"""`zbot doctor`: checks this machine and the domain, and prints advice for each failed check.

With `--tf`, it checks the transforms instead (see `transforms.py`).

The "meeting port" is the port on 127.0.0.1 where the domain's router listens. The nodes of this
machine find each other there.
"""

from __future__ import annotations

import contextlib
import platform
import re
import socket
import sys
import time
from collections import Counter
from dataclasses import dataclass
from importlib.metadata import version
from typing import TYPE_CHECKING, Annotated

import typer

from zbot.errors import ZbotError
from zbot.errors.installation import pip_install
from zbot.errors.suggestion import KnownNames, question
from zbot.graph.snapshot import Snapshot, full_names
from zbot.names import is_hidden
from zbot.package.rclpy_choice import genuine_rclpy
from zbot.text.terminal import escape_control_characters
from zbot.transport import config, environment, running_programs
from zbot.transport.admin_query import processes
from zbot.transport.errors import NoRouterError
from zbot.transport.meeting_port import is_reserved, meeting_port
from zbot.transport.other_version import other_versions_text
from zbot.transport.reserved_ports import reserved_range
from zbot.transport.rmw_choice import RMW_ZENOH, dialect_of_rmw
from zbot.version import __version__
from zbot_cli.domain.client import client, snapshot_of
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import AsJson, new_app, print_json

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.context import Context

app = new_app("Check this machine and the domain for problems", has_verbs=False)

_OLDEST_PYTHON = (3, 10)
_CONNECT_TIMEOUT_S = 0.5
_TESTED_ZENOH = (1, 10)
_LARGEST_CLOCK_STEP_S = 0.1


@dataclass(frozen=True)
class Finding:
    """Result of one check. `advice` says what to do, and is empty if nothing is wrong."""

    check: str
    text: str
    advice: str = ""
    is_warning: bool = False  #: the check passed, but the advice may help if something else fails

    @property
    def is_ok(self) -> bool:
        """Whether the check passed. A check with a warning passed too."""
        return self.is_warning or not self.advice


@app.command()
def doctor(
    target: Annotated[
        str | None, typer.Argument(help="With --tf: frame of the coordinates, e.g. map")
    ] = None,
    source: Annotated[
        str | None, typer.Argument(help="With --tf: frame that is looked for, e.g. laser")
    ] = None,
    transforms: Annotated[bool, typer.Option("--tf", help="Check the transforms instead")] = False,
    seconds: Annotated[
        float, typer.Option("--seconds", help="Seconds to listen for transforms", min=0)
    ] = 5.0,
    report: Annotated[
        bool, typer.Option("-r", "--report", help="List nodes, topics and processes too")
    ] = False,
    report_failed: Annotated[
        bool, typer.Option("-rf", "--report-failed", help="Turn on --report if a check fails")
    ] = False,
    include_warnings: Annotated[
        bool, typer.Option("-iw", "--include-warnings", hidden=True, help="Accepted; no effect")
    ] = False,
    exclude_packages: Annotated[
        bool, typer.Option("-ep", "--exclude-packages", hidden=True, help="Accepted; no effect")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Check this machine and the domain for problems."""
    frames = [name for name in (target, source) if name is not None]
    if transforms:
        _check_transforms(frames, seconds, as_json=as_json)
        return
    if frames:
        raise typer.BadParameter("frames need the option --tf")
    findings = list(_local_findings())
    with _client_or_none() as context:
        graph = Snapshot(()) if context is None else snapshot_of(context)
        findings += _graph_findings(graph)
        if context is not None and not context.is_closed:
            findings += _other_versions(context)
        is_wanted = report or (report_failed and not all(finding.is_ok for finding in findings))
        if is_wanted and context is not None and not context.is_closed:
            findings += _report(context, graph)
    bad = [finding for finding in findings if not finding.is_ok]
    if as_json:
        print_json(
            [
                {
                    "check": finding.check,
                    "ok": finding.is_ok,
                    "warning": finding.is_warning,
                    "text": finding.text,
                    "advice": finding.advice,
                }
                for finding in findings
            ]
        )
    else:
        _print(findings, len(bad))
    if bad:
        raise typer.Exit(Status.ERROR)


def _check_transforms(frames: list[str], seconds: float, *, as_json: bool) -> None:
    from zbot_cli.commands.doctor.transforms import check_transforms  # noqa: PLC0415 - seldom used

    if len(frames) not in {0, 2}:
        raise typer.BadParameter("name two frames, e.g. zbot doctor --tf map laser")
    check_transforms(frames, seconds=seconds, as_json=as_json)


def _print(findings: list[Finding], bad: int) -> None:
    for finding in findings:
        mark = "WARN" if finding.is_warning else "ok  " if finding.is_ok else "FAIL"
        print(f"{mark}  {finding.check}: {finding.text}")
        if finding.advice:
            print(f"      -> {finding.advice}")
    print()
    warnings = sum(finding.is_warning for finding in findings)
    ending = f", with {warnings} warning(s)" if warnings else ""
    total = len(findings)
    print(f"{bad}/{total} check(s) failed{ending}" if bad else f"All {total} checks passed{ending}")


@contextlib.contextmanager
def _client_or_none() -> Iterator[Context | None]:
    try:
        with client() as context:
            yield context
    except ZbotError:
        yield None  # the checks of the configuration report the error


def _speaks_ros2() -> bool:
    with contextlib.suppress(ZbotError):  # the check of the configuration reports the error
        dialect = dialect_of_rmw(None, in_class=False, file=config.load())
        return dialect.identifier == RMW_ZENOH
    return False


def _local_findings() -> Iterator[Finding]:
    checks: tuple[tuple[str, Callable[[], Finding]], ...] = (
        ("python", _python),
        ("zbot", _versions),
        ("domain", _domain),
        ("discovery range", _range),
        ("configuration", _configuration),
        ("loopback", _loopback),
        ("meeting port", _ros2_router if _speaks_ros2() else _meeting_port),
        ("clock", _clock),
        ("class", _class),
        ("visible nodes", _visibility),
        ("rclpy", _rclpy),
    )
    for name, check in checks:
        try:
            yield check()
        except ZbotError as error:
            yield Finding(name, "not usable", str(error))
    with contextlib.suppress(ZbotError):  # the checks above report the error
        yield from _environment()
        yield from _programs_outside()


def _python() -> Finding:
    text = f"{platform.python_version()} ({sys.executable})"
    old = sys.version_info < _OLDEST_PYTHON
    return Finding("python", text, "install Python 3.10 or newer" if old else "")


def _versions() -> Finding:
    zenoh, machine = version("eclipse-zenoh"), f"{platform.system()} {platform.machine()}"
    text = f"{__version__}, eclipse-zenoh {zenoh}, {machine}"
    tested = ".".join(map(str, _TESTED_ZENOH))
    remedy = pip_install(f"eclipse-zenoh=={tested}.*")
    found = tuple(int(part) for part in re.findall(r"\d+", zenoh)[:2])
    if found > _TESTED_ZENOH:
        advice = f"zbot was tested with Zenoh {tested}: if something fails, try {remedy}"
        return Finding("zbot", text, advice, is_warning=True)
    return Finding(
        "zbot", text, f"this Zenoh is too old: {remedy}" if found < _TESTED_ZENOH else ""
    )


def _domain() -> Finding:
    return Finding("domain", str(config.domain_id()))


def _range() -> Finding:
    found = config.discovery_range()
    off = found is config.DiscoveryRange.OFF
    return Finding(
        "discovery range",
        found.value,
        "unset ZBOT_DISCOVERY_RANGE: its value OFF hides all nodes" if off else "",
    )


def _configuration() -> Finding:
    found = config.load()
    found.build({})
    return Finding("configuration", found.source)


def _loopback() -> Finding:
    with socket.socket() as listener, socket.socket() as caller:
        try:
            listener.bind(("127.0.0.1", 0))
            listener.listen()
            caller.settimeout(_CONNECT_TIMEOUT_S)
            caller.connect(listener.getsockname())
        except OSError as exc:
            advice = "allow local connections (127.0.0.1) in the firewall"
            return Finding("loopback", f"a connection to this machine fails: {exc}", advice)
    return Finding("loopback", "programs of this machine can connect to each other")


def _meeting_port() -> Finding:
    port = meeting_port(config.domain_id())
    name = f"127.0.0.1:{port}"
    usual = config.MEETING_PORT + config.domain_id()
    if port != usual:
        name += f" instead of {usual}, because the system reserves {reserved_range(usual)},"
    with socket.socket() as probe:
        probe.settimeout(_CONNECT_TIMEOUT_S)
        if probe.connect_ex(("127.0.0.1", port)) != 0:
            return _unused_port(port, name)
    with _client_or_none() as context:
        if context is not None and not context.is_closed:
            return Finding("meeting port", f"{name} answers as zbot")
    advice = "end the program that uses it, or choose another domain: ZBOT_DOMAIN_ID=7"
    return Finding("meeting port", f"{name} is used by a program that is not zbot", advice)


def _unused_port(port: int, name: str) -> Finding:
    if is_reserved(port):
        advice = "let the system release the ports, or choose another domain: ZBOT_DOMAIN_ID=107"
        text = f"programs cannot use {name}: the system reserves {reserved_range(port)}"
        return Finding("meeting port", text, advice)
    return Finding("meeting port", f"{name} is free: no node is running in this domain")


def _ros2_router() -> Finding:
    try:
        with client():
            return Finding("ROS 2 router", "it answers, and programs speak rmw_zenoh_cpp")
    except NoRouterError as error:
        return Finding("ROS 2 router", "none answers", str(error))


def _clock() -> Finding:
    started, steady = time.time(), time.monotonic()
    # The connection takes some time. A clock that is being corrected may jump during this time.
    with socket.socket() as probe:
        probe.connect_ex(("127.0.0.1", 9))
    step = (time.time() - started) - (time.monotonic() - steady)
    if abs(step) > _LARGEST_CLOCK_STEP_S:
        return Finding(
            "clock",
            f"the system's clock jumps ({step:+.1f} s)",
            "check the machine's time synchronisation",
        )
    return Finding("clock", "steady")


def _class() -> Finding:
    from zbot.classroom.machine_state import present_state  # noqa: PLC0415 - not needed by `--help`

    state = present_state()
    if state["role"] is None:
        return Finding("class", "this machine has joined nothing")
    where = f"{state['class'] or 'a hub'} as {state['role']}"
    if not state["hub"]:
        return Finding("class", f"joined {where}", environment.missing_hub())
    if state["problem"]:
        link = "linked" if state["linked"] else "not linked"
        return Finding("class", f"joined {where}, {link}", state["problem"])
    join = state["join"]
    if join and join["former_host"]:
        advice = f"students must join again at {join['host']}, the new address of this machine"
        return Finding("class", f"opened {where} at {join['former_host']}", advice)
    return Finding("class", f"joined {where}")


def _visibility() -> Finding:
    from zbot.classroom.student.visibility import settled  # noqa: PLC0415 - not needed by `--help`

    found = settled()
    if found is None:
        return Finding("visible nodes", "no hub of this machine answers")
    seen = f"{len(found.running)} running, this machine's hub sees {len(found.hub)}"
    if found.of_class is not None:
        seen += f", and the class sees {len(found.of_class)}"
    problems = "; ".join(found.problems())
    advice = f"{problems}: end these nodes and start them again" if problems else ""
    return Finding("visible nodes", seen, escape_control_characters(advice))


def _environment() -> Iterator[Finding]:
    for difference in environment.differences():
        yield Finding(
            "environment", difference.setting, difference.text, is_warning=not difference.hides
        )


def _programs_outside() -> Iterator[Finding]:
    count = sum(len(program.nodes) for program in running_programs.outside())
    if count:
        advice = escape_control_characters(running_programs.outside_text())
        yield Finding("running nodes", f"{count} outside the class", advice)


def _rclpy() -> Finding:
    """Return whether `zbot bridge dds` would find a genuine rclpy."""
    folder = genuine_rclpy()
    if folder is None:
        return Finding("rclpy", "zbot's own; `zbot bridge dds` needs a genuine one")
    return Finding("rclpy", f"a genuine one in {folder}; `zbot run` uses zbot's own")


def _graph_findings(graph: Snapshot) -> list[Finding]:
    visible = [node for node in graph.nodes if not is_hidden(node.full_node_name)]
    return [
        Finding("nodes", f"{len(visible)} running"),
        *_duplicate_names(graph),
        *_type_clashes(graph),
        *_lonely_subscriptions(graph),
        *_bridges(graph),
    ]


def _bridges(graph: Snapshot) -> Iterator[Finding]:
    from zbot.bridge.bridge_graph import bridges_in  # noqa: PLC0415 - few machines have one

    for view in bridges_in(graph.tokens).values():
        text = f"topics and services: {len(view.names)}, nodes of ROS 2: {len(view.nodes)}"
        if view.nodes or view.names:
            yield Finding("bridge", text)
        else:
            advice = (
                "is the robot on, and is --ros-domain the robot's domain? If the robot's program "
                "runs on this machine, is its ROS_AUTOMATIC_DISCOVERY_RANGE the same? If there are "
                "two bridges, only one of them passes messages on"
            )
            yield Finding("bridge", text, advice, is_warning=True)


def _duplicate_names(graph: Snapshot) -> Iterator[Finding]:
    for name, count in Counter(full_names(graph.nodes)).items():
        if count > 1:
            advice = "end all but one, or rename: --ros-args -r __node:=another_name"
            yield Finding("node names", f"{count} nodes are named {name}", advice)


def _type_clashes(graph: Snapshot) -> Iterator[Finding]:
    for name, types in graph.topics():
        if len(types) > 1:
            who = sorted(set(full_names([*graph.publishers(name), *graph.subscriptions(name)])))
            advice = f"use one type in all nodes, or rename the topic; nodes: {', '.join(who)}"
            yield Finding("topic types", f"{name} has {len(types)}: {', '.join(types)}", advice)


def _lonely_subscriptions(graph: Snapshot) -> Iterator[Finding]:
    published = {name for name, _ in graph.topics() if graph.publishers(name)}
    known = KnownNames(published)
    for name, _ in graph.topics():
        if name in published or is_hidden(name):
            continue
        guess = known.nearest(name)
        if guess is not None:
            advice = f"{question([guess])} It has a publisher"
            yield Finding("topic names", f"{name} has no publisher", advice)


def _other_versions(context: Context) -> Iterator[Finding]:
    """Return a warning if processes of the domain have another version of zbot."""
    versions = {
        f"{process.command} on {process.host} (process {process.pid})": process.version
        for process in processes(context.session).values()
    }
    text = other_versions_text(versions)
    if text:
        what, _, advice = text.rpartition(". ")
        yield Finding("versions", what, advice, is_warning=True)


def _report(context: Context, graph: Snapshot) -> Iterator[Finding]:
    # The process that listens on the meeting port has two sessions, but it is listed only once.
    found = {
        (process.host, process.space, process.pid): process
        for process in processes(context.session).values()
    }
    for process in sorted(found.values(), key=lambda process: (process.host, process.pid)):
        yield Finding(
            "process", f"{process.host} {process.pid} ({process.command}), zbot {process.version}"
        )
    for name in full_names(graph.nodes):
        yield Finding("node", name)
    for name, types in graph.topics():
        ends = (len(graph.publishers(name)), len(graph.subscriptions(name)))
        counts = "{} publisher(s), {} subscription(s)".format(*ends)
        yield Finding("topic", f"{name} [{', '.join(types)}] {counts}")
