"""`zbot doctor --tf`: prints the tree of frames, and what is wrong with it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any, Final

import typer

from zbot.text.terminal import escape_control_characters
from zbot.tf2.diagnosis import TransformMonitor
from zbot.tf2.diagnosis.problem import duration_text
from zbot_cli.domain.client import hidden_node
from zbot_cli.domain.waiting import Sleep
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import print_json

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from zbot.tf2.diagnosis import Branch, Diagnosis, Link, Problem

_GAP: Final = 3  # spaces between two columns


def check_transforms(frames: Sequence[str], *, seconds: float, as_json: bool) -> None:
    """Hear transforms for some seconds. Print the frames and their problems.

    Args:
        frames: Nothing, or the target and the source of the one transform to explain.
        seconds: Seconds to listen.
        as_json: Whether to print JSON.

    Raises:
        typer.Exit: There is a problem that is not only a warning.
    """
    diagnosis = _heard(seconds)
    if frames:
        target, source = frames
        found = diagnosis.why(target, source)
        problems = [] if found is None else [found]
    else:
        problems = diagnosis.problems()
    if as_json:
        print_json(
            {
                "frames": [_facts(link) for link in _all_links(diagnosis)],
                "problems": [_problem_facts(problem) for problem in problems],
            }
        )
    else:
        lines = [*_trees(diagnosis, seconds), *_sentences(problems, frames)]
        print(escape_control_characters("\n".join(lines)))
    if not all(problem.is_warning for problem in problems):
        raise typer.Exit(Status.ERROR)


def _heard(seconds: float) -> Diagnosis:
    from zbot.executor.spin_thread import SpinThread  # noqa: PLC0415 - not needed by `--help`

    with hidden_node("doctor") as node:
        monitor = TransformMonitor(node)
        spinner = SpinThread(node, "zbot doctor")
        Sleep(node.context).until(time.monotonic() + seconds)
        spinner.stop(1)
    return monitor.diagnosis


def _all_links(diagnosis: Diagnosis) -> list[Link]:
    return [link for topic in diagnosis.topics for link in diagnosis.links(topic)]


def _facts(link: Link) -> dict[str, Any]:
    now_ns = time.time_ns()
    return {
        "parent": link.parent,
        "child": link.child,
        "topic": link.topic,
        "nodes": link.nodes,
        "static": link.is_static,
        "rate": None if link.is_static else round(link.rate_hz, 3),
        "age": None if link.is_static else round((now_ns - link.newest_stamp_ns) / 1e9, 3),
    }


def _problem_facts(problem: Problem) -> dict[str, Any]:
    return {
        "cause": problem.cause.value,
        "warning": problem.is_warning,
        "text": problem.text,
        "advice": problem.advice,
        "frames": list(problem.frames),
    }


def _trees(diagnosis: Diagnosis, seconds: float) -> Iterator[str]:
    for topic in diagnosis.topics:
        yield f"Heard on {topic} and {topic}_static for {seconds:g} s:"
        rows = [_row(branch) for branch in diagnosis.branches(topic)]
        yield from _columns(rows) if rows else ["  no transforms"]
        yield ""


def _row(branch: Branch) -> tuple[str, str, str, str]:
    name = "  " * (branch.depth + 1) + branch.frame
    if branch.missing_parent:
        return name, "missing", f"{branch.missing_parent} -> {branch.frame}", ""
    return (name, "", "", "") if branch.link is None else (name, *_shown(branch.link))


def _shown(link: Link) -> tuple[str, str, str]:
    nodes = ", ".join(link.nodes)
    now_ns = time.time_ns()
    if link.is_static:
        return "static", "", nodes
    if link.is_stale(now_ns):
        return "stopped", f"{duration_text(link.silence_ns(now_ns))} ago", nodes
    return link.rate_text, link.age_text(now_ns), nodes


def _columns(rows: Sequence[tuple[str, ...]]) -> Iterator[str]:
    widths = [max(map(len, column)) + _GAP for column in zip(*rows, strict=True)]
    for row in rows:
        cells = (cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        yield "".join(cells).rstrip()


def _sentences(problems: Sequence[Problem], frames: Sequence[str]) -> Iterator[str]:
    for problem in problems:
        yield f"{'WARN' if problem.is_warning else 'FAIL'}  {problem.cause.value}: {problem.text}"
        yield f"      -> {problem.advice}"
    if frames and not problems:
        yield f"ok    the transform from {frames[1]} to {frames[0]} is known"
    elif problems:
        warnings = sum(problem.is_warning for problem in problems)
        ending = f", with {warnings} warning(s)" if warnings else ""
        yield f"\n{len(problems)} problem(s){ending}"
    else:
        yield "No problem found"
