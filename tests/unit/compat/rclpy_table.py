"""The table of rclpy's public names: which zbot has, which not, and why.

Write it with: python -m tests.unit.compat.rclpy_table
"""

from __future__ import annotations

import importlib
import json
from pathlib import Path

import zbot.compat  # noqa: F401 - makes rclpy importable

HERE = Path(__file__).parent
TABLE = HERE.parents[2] / "docs" / "rclpy.md"
_HEAD = """\
# rclpy's names in zbot

Every public module, class, function and method of rclpy 9.1 (ROS 2 Kilted), and whether a program
finds it here. This page is written by `python -m tests.unit.compat.rclpy_table`; a test keeps it
true.

Some of what programs meet differs on purpose:

* A call of a service that has no server, or whose server ends, fails at once with a `ServiceError`;
  in rclpy its future stays pending for ever.
* What a node owns leaves the graph with its node, an action server too; in rclpy that stays until
  its own `destroy()`.
* A rate sleeps without an executor that spins in another thread.
* A `MultiThreadedExecutor` has at least two threads unless it is told otherwise.

"""
#: Why something is not there; by module, by `module.name`, or by the name alone.
WHY = {
    "add_to_wait_set": "takes a wait set of the C library",
    "is_ready": "takes a wait set of the C library",
    "get_num_entities": "counts what goes into a wait set of the C library",
    "take_data": "takes from the C library what its wait set found",
    "execute": "works on what the C library's wait set found",
    "notify_goal_done": "tells the C library that an answer is due",
    "get_c_duration": "returns a struct of the C library",
    "track_node": "holds nodes of the C library",
    "untrack_node": "holds nodes of the C library",
    "create_event_handlers": "makes handles of the C library",
}


def why(module: str, name: str, member: str = "") -> str:
    """Return why a name is absent, or an empty text."""
    for key in (member, name, f"{module}.{name}", module):
        if key in WHY:
            return WHY[key]
    return ""


def rows(module_name: str, names: dict[str, list[str] | None]) -> list[str]:
    """Return the lines of one module."""
    try:
        module: object = importlib.import_module(module_name)
    except ImportError:
        module = None
    lines = []
    for name, members in names.items():
        found = getattr(module, name, None)
        if found is None:
            lines.append(f"| `{name}` | absent | {why(module_name, name)} |")
            continue
        missing = [one for one in members or () if not _has(found, one)]
        reasons = {why(module_name, name, member) for member in missing} - {""}
        note = f"without {', '.join(f'`{one}`' for one in missing)}" if missing else ""
        note += f": {'; '.join(sorted(reasons))}" if reasons else ""
        lines.append(f"| `{name}` | present | {note} |")
    return lines


def _has(found: object, member: str) -> bool:
    """Return whether objects of a class have a member; aliases and fields count."""
    fields: dict[str, object] = getattr(found, "__dataclass_fields__", {})
    annotated: dict[str, object] = getattr(found, "__annotations__", {})
    # In this order: a property that lists a node's parts cannot be asked of the class.
    return member in dir(found) or member in fields or member in annotated or hasattr(found, member)


def table() -> str:
    """Return the whole page."""
    known = json.loads((HERE / "rclpy_names.json").read_text(encoding="utf-8"))
    blocks, present, total = [], 0, 0
    for module, names in sorted(known.items()):
        lines = rows(module, names)
        present += sum("| present |" in line for line in lines)
        total += len(lines)
        head = f"## {module}\n\n| name | | |\n|---|---|---|\n"
        blocks.append(head + "\n".join(lines) + "\n")
    count = f"{present} of {total} names are there.\n\n"
    return _HEAD + count + "\n".join(blocks)


def main() -> None:
    """Write the page."""
    TABLE.write_text(table(), encoding="utf-8")


if __name__ == "__main__":
    main()
