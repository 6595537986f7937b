"""Table of `zbot class list`."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.transport.other_version import other_versions_text

if TYPE_CHECKING:
    from zbot.classroom.teacher.invitation import Invitation

_HEADINGS = ("", "name", "host", "nodes", "clock", "version", "")
_SECONDS = {"s": 60.0, "min": 60.0, "h": 24.0, "d": float("inf")}


def table(found: dict[str, Any], invitation: Invitation) -> str:
    """Return the students of a class as text, with one student per line."""
    rows = [_HEADINGS, *(_row(student) for student in found["students"])]
    rows += [
        (str(student["number"]), student["name"], "-", "", "", "", "")
        for student in found["expected"]
    ]
    here = sum(student["here"] for student in found["students"])
    lines = _aligned(rows) if len(rows) > 1 else ["nobody has joined yet"]
    heading = f'"{found["class"]}": {here} here; {invitation.command}'
    heading += f"; PIN: {invitation.pin}" if invitation.pin else ""
    names = {student["number"]: student["name"] for student in found["students"]}
    # An older version of zbot sends no list of robots.
    lines += [_robot_line(robot, names) for robot in found.get("robots", ())]
    versions = {
        f"{student['name']} (number {student['number']})": student["version"]
        for student in found["students"]
        if student["here"]
    }
    difference = other_versions_text(versions)
    return "\n".join([heading, *lines, *([difference] if difference else [])])


def _robot_line(robot: dict[str, Any], names: dict[int, str]) -> str:
    number = robot["driver"]
    who = "nobody" if number is None else f"{names.get(number, '')} (number {number})".strip()
    return f"robot {robot['name']}: {who} drives"


def _row(student: dict[str, Any]) -> tuple[str, ...]:
    error = student["last_error"]
    offset = student["clock_offset"]
    count, more = len(student["nodes"]), student["more_nodes"]
    remark = f"{error['node']}: {error['text']}" if error else ""
    if more:
        remark = f"more than {count} nodes, the rest is not shown"
    if not student["here"]:
        remark = f"lost {_ago(student['since'])}" if student["since"] else "not seen yet"
    return (
        str(student["number"]),
        student["name"],
        student["host"],
        f"{count}+" if more else str(count),
        "" if offset is None else f"{offset:+.3f} s",
        student["version"],
        remark,
    )


def _ago(since_s: float) -> str:
    left = max(0.0, time.time() - since_s)
    for unit, size in _SECONDS.items():
        if left < size:
            return f"{left:.0f} {unit} ago"
        left /= size
    return ""


def _aligned(rows: list[tuple[str, ...]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]
