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

"""
#: Why something is not there; by module, by `module.name`, or by the name alone.
WHY = {
    "rclpy.impl.rcutils_logger": "log filters are keyword arguments here, without classes",
    "rclpy.type_support": "a type for checkers only",
    "rclpy.subscription_content_filter_options": "Zenoh filters by key, not by content",
    "ConditionReachedException": "inner part of rclpy's executors",
    "TimeoutObject": "inner part of rclpy's executors",
    "SignalHandlerGuardCondition": "signals wake executors directly",
    "FutureState": "`done()`, `cancelled()` and `exception()` tell it",
    "TypeDescriptionService": "every node has the service, without an object for it",
    "TypeHashDictionary": "a type for checkers only",
    "TimeJumpDictionary": "a type for checkers only",
    "SendGoalKWargs": "a type for checkers only",
    "CreateLifecyclePublisherArgs": "a type for checkers only",
    "LifecycleNodeArgs": "a type for checkers only",
    "add_to_wait_set": "zbot's own kinds of work need no wait set",
    "is_ready": "zbot's own kinds of work need no wait set",
    "get_num_entities": "zbot's own kinds of work need no wait set",
    "add_future": "zbot's own kinds of work need no wait set",
    "take_data": "zbot's own kinds of work need no wait set",
    "short_key": "the policies' names are enough",
    "notify_goal_done": "inner part of rclpy",
    "callback": "given to the constructor, and not shown",
    "status": "it comes with the result",
    "handle": "there is no object of rcl below it",
    "track_node": "inner part of rclpy",
    "untrack_node": "inner part of rclpy",
    "get_c_duration": "there is no C library",
    "get_c_qos_profile": "there is no C library",
    "create_event_handlers": "inner part of rclpy",
    "await_or_execute": "inner part of rclpy's executors",
    "rclpy.logging.initialize": "logging needs no beginning",
    "rclpy.logging.shutdown": "logging needs no end",
    "send_response": "the callback's return value is sent",
    "get_content_filter": "Zenoh filters by key, not by content",
    "set_content_filter": "Zenoh filters by key, not by content",
    "is_cft_enabled": "Zenoh filters by key, not by content",
    "attach_clock": "a node's time source has its clock",
    "attach_node": "a node's time source has its node",
    "detach_node": "a node's time source has its node",
    "clock_callback": "inner part of rclpy",
    "RMW_QOS_POLICY_DURABILITY_UNKNOWN": "a name of C",
    "can_execute": "inner part of rclpy's executors",
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
