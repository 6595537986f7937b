"""Robots of a class: the bridge of each robot runs in the background of the teacher's machine."""

from __future__ import annotations

import contextlib
import re
import subprocess
import threading
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.bridge.rclpy_import import import_rclpy
from zbot.classroom.hub.running_hub import READY, report_ready
from zbot.security.secret import make_private_folder
from zbot.threads.wakeup import LONGEST_WAIT_S
from zbot.transport import background_process, membership
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context

_SPEC = re.compile(r"(?:(?P<name>[a-z][a-z0-9_]*)=)?dds(?::(?P<domain>\d{1,3}))?")
_END_S = 5.0


def robot_start_error(name: str, log: str, last_line: str) -> CommandError:
    """Return the error that the bridge of a robot did not start."""
    return CommandError(f"the bridge of the robot {name!r} did not start: {last_line or log}")


@dataclass(frozen=True)
class RobotSpec:
    """Robot that a value of `--robot` describes."""

    name: str  #: its topics are in `/class/NAME/`
    ros_domain: int

    @classmethod
    def parse(cls, text: str) -> RobotSpec:
        """Parse a text such as `dds`, `dds:5` or `arm=dds:5`.

        Raises:
            CommandError: The text has another form.
        """
        found = _SPEC.fullmatch(text)
        if found is None or int(found["domain"] or 0) > 232:
            raise CommandError(
                f"cannot use --robot {text!r}: write dds, dds:DOMAIN or NAME=dds:DOMAIN, "
                "e.g. arm=dds:5"
            )
        return cls(found["name"] or "robot", int(found["domain"] or 0))


def check_rclpy() -> None:
    """Check that this Python can import a genuine rclpy. Raise `BridgeError` if it cannot."""
    import_rclpy()


def start(robot: RobotSpec, rates: list[str]) -> None:
    """Start a robot's bridge in the background. The bridge ends when the class is closed.

    Raises:
        CommandError: The bridge did not start. The error has the last line of the bridge's log.
    """
    folder = membership.folder()
    make_private_folder(folder)
    path = folder / f"robot-{robot.name}.log"
    words = [robot.name, "--ros-domain", str(robot.ros_domain)]
    words += [f"--rate={rate}" for rate in rates]
    with path.open("w", encoding="utf-8") as log:
        process = background_process.start(
            "zbot_cli",
            "class",
            "run-robot",
            *words,
            stdout=subprocess.PIPE,
            stderr=log,
            cwd=folder,
        )
    assert process.stdout is not None
    with process.stdout as lines:
        is_ready = any(line.strip() == READY for line in lines)
    if not is_ready:
        process.wait(_END_S)
        last = path.read_text(encoding="utf-8").strip().splitlines()[-1:]
        raise robot_start_error(robot.name, str(path), "".join(last))
    background_process.forget(process)


def run(robot: RobotSpec, rates: list[str]) -> None:
    """Run a robot's bridge until the class is closed."""
    from zbot.bridge.bridge import BridgeOptions, run_dds  # noqa: PLC0415 - in the background only
    from zbot.bridge.selection import Selection, read_rate  # noqa: PLC0415 - as above
    from zbot.classroom.teacher.driver_filter import DriverFilter  # noqa: PLC0415 - as above

    def make_filter(
        context: Context, stop: Callable[[], None], end: Callable[[], None]
    ) -> DriverFilter:
        return DriverFilter(context, robot.name, stop, end)

    lock = background_process.lock_path(f"robot-{robot.name}")
    with lock.open("a", encoding="utf-8") as file:
        if not background_process.lock(file):
            report_ready()  # the bridge of this robot runs already
            return
        run_dds(
            BridgeOptions(
                ros_domain=robot.ros_domain,
                prefix=f"/class/{robot.name}",
                selection=Selection(rates=tuple(map(read_rate, rates))),
                make_filter=make_filter,
                on_ready=report_ready,
            )
        )


def until_key(told: dict[str, Any], take_back: Callable[[], object]) -> None:
    """Print who drives the robot. On a terminal, wait for a key, and then take the robot back."""
    from zbot_cli.input.keyboard import has_keyboard, keys_to  # noqa: PLC0415 - for a terminal only

    who = f"{told['name']} (number {told['number']})"
    if not has_keyboard():
        print(f"{who} drives {told['robot']}; `zbot class take {told['robot']}` takes it back")
        return
    print(f"{who} drives {told['robot']}. Press any key to take it back.", flush=True)
    pressed = threading.Event()
    try:
        with contextlib.suppress(KeyboardInterrupt), keys_to(lambda _: pressed.set()):
            while not pressed.wait(LONGEST_WAIT_S):
                continue
    finally:
        take_back()
        print(f"nobody drives {told['robot']}")
