"""Table of rclpy's public names: present or absent in zbot, with the reason.

Write it with: python -m tests.unit.compat.rclpy_table
"""

from __future__ import annotations

import dis
import importlib
import inspect
import json
import types
from pathlib import Path
from typing import Any

import zbot.compat  # noqa: F401 - makes rclpy importable
from zbot import ReentrantCallbackGroup

HERE = Path(__file__).parent
TABLE = HERE.parents[2] / "docs" / "rclpy.md"
#: Every public name of rclpy 9.1 by its module; of a class, its public members.
NAMES: dict[str, dict[str, list[str] | None]] = json.loads(
    (HERE / "rclpy_names.json").read_text(encoding="utf-8")
)
_HEAD = """\
# rclpy's names in zbot

This page lists every public module, class, function and method of rclpy 9.1 (ROS 2 Kilted).

* **present**: the name is there. The tests in `tests/unit/compat/rclpy_calls/` call each of its
  methods.
* **partly**: the class is there. The listed methods are absent, have no effect, or do less.
* **no-op**: programs can import the name, but it has no effect. Nearly all of these names are for
  type annotations.
* **absent**: the name is not there.

The last column of the tables has reasons. There, "the C library" means `rcl`. rclpy uses this
library, and zbot does not use it.

`python -m tests.unit.compat.rclpy_table` writes this page. A test compares the page with the code.

zbot differs from rclpy on purpose in these points:

* `call()` without a server fails immediately with a `ServiceError`. In rclpy it waits for ever. The
  future of `call_async()` without a server is never done, as in rclpy, and zbot logs a warning.
* Both calls fail if their server ends. In rclpy, they wait for ever.
* After SIGTERM, a program that does not call `ok()` ends after 3 s. In rclpy, it goes on.
* `spin_once` in a second thread waits for the next callback of the thread that spins the node. In
  rclpy, the node leaves the executor of that thread.
* A forked child process may call `init()` after its parent did. In rclpy, it needs a new context.
* When a node is destroyed, all its entities disappear from the graph at the same time. This is
  also true for action servers. In rclpy an action server stays until its own `destroy()`.
* After `destroy_node()`, methods such as `get_name()` and `get_node_names()` still answer. In
  rclpy, they raise `InvalidHandle`.
* Callbacks are checked when a program gives them: one that cannot be called is an error. In rclpy,
  the error comes when the callback is called. A lambda that does nothing is accepted with a
  warning.
* A client receives the acceptance of its goal before the goal's callback runs, also if both are in
  one executor. In rclpy, the callback runs first there.
* `Executor.shutdown(timeout_sec=0)` returns `False` while another thread spins, also without a
  callback.
* `Rate.sleep()` works even if no executor spins in another thread.
* A publisher and a subscription always connect. In ROS 2, a best effort publisher sends nothing
  to a reliable subscription, and both log a warning.
* `call()` works in a callback. In rclpy, it waits for ever if the executor has one thread.
* A parameter with a floating-point number takes an integer, as 1.0 for 1. In rclpy,
  `set_parameters` refuses it.
* Callbacks run in the order in which their messages, timers and requests came. In rclpy, timers
  run first.
* A server that rejects the cancellation of a goal answers `ERROR_REJECTED`, as in C++. In rclpy,
  the code is `ERROR_NONE`.
* A rule such as `chatter:=/chat` needs `--ros-args -r`. Without it, zbot logs what to write. In
  rclpy, the rule works, and a warning says that this form is deprecated.
* `Logger.info(3)`, a second `shutdown()`, and `copy.deepcopy` of a `Time` work. In rclpy, they
  raise an error.
* A `MultiThreadedExecutor` has at least two threads if the program does not give a number.
* Messages check every value that a program assigns, also with `check_fields=False`. If the variable
  `ROS_PYTHON_CHECK_FIELDS` is 0, it is as in rclpy: a message checks values only if it is made
  with `check_fields=True`. If a message has a wrong value, `publish` still
  raises a `CodecError`.

"""
#: Reasons for absent names; by module, by `module.name`, or by the name alone.
WHY = {
    "add_to_wait_set": "uses a wait set of the C library",
    "is_ready": "uses a wait set of the C library",
    "get_num_entities": "counts entities for a wait set of the C library",
    "take_data": "uses a wait set of the C library",
    "execute": "uses a wait set of the C library",
    "notify_goal_done": "changes an object of the C library",
    "get_c_duration": "returns a struct of the C library",
    "track_node": "takes nodes of the C library",
    "untrack_node": "takes nodes of the C library",
    "create_event_handlers": "makes handles of the C library",
}
#: Methods that do less than in rclpy, by class and method.
LIMITED = {
    "Publisher.assert_liveliness": "subscriptions do not notice the end of a "
    "`MANUAL_BY_TOPIC` lease",
    "Publisher.wait_for_all_acked": "returns `False` if another program has a reliable "
    "subscription, because other programs send no acknowledgements",
}
#: Names without effect, for annotations only, as in rclpy.
ANNOTATIONS = {
    *("rclpy.action.client.SendGoalKWargs", "rclpy.clock.TimeJumpDictionary"),
    *(
        "rclpy.lifecycle.node.CreateLifecyclePublisherArgs",
        "rclpy.lifecycle.node.LifecycleNodeArgs",
    ),
    *("rclpy.type_hash.TypeHashDictionary",),
    *(f"rclpy.type_support.{name}" for name in NAMES["rclpy.type_support"] if name[0].isupper()),
}


def find(module: str, name: str) -> Any:
    """Return the object of a name of a module; `None` if it is absent."""
    try:
        return getattr(importlib.import_module(module), name, None)
    except ImportError:
        return None


def absent_members(found: object, members: list[str] | None) -> list[str]:
    """Return the members that objects of a class do not have."""
    return [member for member in members or () if not _has(found, member)]


def _has(found: object, member: str) -> bool:
    fields: dict[str, object] = getattr(found, "__dataclass_fields__", {})
    annotated: dict[str, object] = getattr(found, "__annotations__", {})
    # `hasattr` is last: a property that lists a node's entities cannot be read from the class.
    return member in dir(found) or member in fields or member in annotated or hasattr(found, member)


def idle_members(found: object, members: list[str] | None) -> list[str]:
    """Return the methods of a class that do nothing for any arguments."""
    if found is ReentrantCallbackGroup:
        return []  # it lets every callback run, as in rclpy
    return [
        member for member in members or () if is_idle(inspect.getattr_static(found, member, None))
    ]


def is_idle(function: object) -> bool:
    """Return whether a function has no statement but its docstring, or returns a constant."""
    if not isinstance(function, types.FunctionType):
        return False
    code = function.__code__
    return not code.co_names and not code.co_freevars and not _loads(code)


def _loads(code: types.CodeType) -> bool:
    """Return whether a function reads its arguments or computes anything."""
    idle = {"RESUME", "NOP", "LOAD_CONST", "RETURN_VALUE", "RETURN_CONST", "LOAD_SMALL_INT"}
    return any(step.opname not in idle for step in dis.get_instructions(code))


def row(module: str, name: str, members: list[str] | None) -> str:
    """Return the table row of one name."""
    found = find(module, name)
    if found is None:
        return f"| `{name}` | absent | {WHY.get(name, '')} |"
    if f"{module}.{name}" in ANNOTATIONS or is_idle(found):
        return f"| `{name}` | no-op | |"
    absent, idle = absent_members(found, members), idle_members(found, members)
    notes = [f"absent: {_listed(absent)}"] if absent else []
    notes += [f"no effect: {_listed(idle)}"] if idle else []
    limited = {member: LIMITED.get(f"{name}.{member}") for member in members or ()}
    notes += [f"limited: `{member}` ({why})" for member, why in limited.items() if why]
    return f"| `{name}` | {'partly' if notes else 'present'} | {'; '.join(notes)} |"


def _listed(members: list[str]) -> str:
    reasons: dict[str, list[str]] = {}
    for member in members:
        reasons.setdefault(WHY.get(member, ""), []).append(f"`{member}`")
    return "; ".join(_reasoned(group, reason) for reason, group in reasons.items())


def _reasoned(group: list[str], reason: str) -> str:
    subject = "each" if len(group) > 1 else "it"
    return ", ".join(group) + (f" ({subject} {reason})" if reason else "")


def table() -> str:
    """Return the whole page."""
    blocks, lines = [], []
    for module, names in sorted(NAMES.items()):
        rows = [row(module, name, members) for name, members in names.items()]
        lines += rows
        blocks.append(
            f"## {module}\n\n| name | state | |\n|---|---|---|\n" + "\n".join(rows) + "\n"
        )
    states = ("present", "partly", "no-op", "absent")
    counts = {state: sum(f"| {state} |" in line for line in lines) for state in states}
    summary = ", ".join(f"{count} {state}" for state, count in counts.items())
    return f"{_HEAD}Of {len(lines)} names: {summary}.\n\n" + "\n".join(blocks)


def main() -> None:
    """Write the page."""
    TABLE.write_text(table(), encoding="utf-8")


if __name__ == "__main__":
    main()
