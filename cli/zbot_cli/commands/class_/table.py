"""Table of `zbot class list`."""

from __future__ import annotations

import time
from typing import Any

_HEADINGS = ("", "name", "host", "nodes", "clock", "version", "")
_SECONDS = {"s": 60.0, "min": 60.0, "h": 24.0, "d": float("inf")}


def table(found: dict[str, Any]) -> str:
    """Return the students of a classroom as text, with one student per line."""
    rows = [_HEADINGS, *(_row(student) for student in found["students"])]
    rows += [(str(one["number"]), one["name"], "-", "", "", "", "") for one in found["expected"]]
    here = sum(student["here"] for student in found["students"])
    lines = _aligned(rows) if len(rows) > 1 else ["nobody has joined yet"]
    return "\n".join([f'"{found["class"]}": {here} here', *lines])


def _row(student: dict[str, Any]) -> tuple[str, ...]:
    error = student["last_error"]
    offset = student["clock_offset"]
    remark = f"{error['node']}: {error['text']}" if error else ""
    if not student["here"]:
        remark = f"lost {_ago(student['since'])}" if student["since"] else "not seen yet"
    return (
        str(student["number"]),
        student["name"],
        student["host"],
        str(len(student["nodes"])),
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
