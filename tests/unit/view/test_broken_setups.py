"""Twelve broken set-ups of transforms: the display of a scan says what `zbot doctor --tf` says."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import pytest

from tests.unit.tf2.diagnosis.robot import SECOND
from tests.unit.tf2.diagnosis.robot import Robot as Diagnosed
from tests.unit.view.messages import framed, scan
from zbot.view.displays.laser_scan import LaserScan
from zbot.view.frames import Frames
from zbot.view.shown import Shown
from zbot_cli.commands.doctor.transforms import _sentences

if TYPE_CHECKING:
    from collections.abc import Callable


class Robot(Diagnosed):
    """Robot whose transforms the view hears too, and the display of its scan."""

    def __init__(self) -> None:
        super().__init__()
        self.frames = Frames()
        self.frames.diagnosis = self.diagnosis
        self.frames.now_ns = lambda: self.now_ns
        self.shown = Shown(LaserScan("/scan"), [])
        self.age_ns = 0

    def publish(self, parent: str, child: str, **options: Any) -> None:
        super().publish(parent, child, **options)
        topic = options.get("topic", "/tf")
        if topic not in {"/tf", "/tf_static"}:
            return
        message = self.last_message
        is_static = topic == "/tf_static"
        add = self.frames.set_transform_static if is_static else self.frames.set_transform
        add(message, options.get("node", "/driver"))

    def shows(self, fixed: str, frame: str) -> bool:
        """Show a scan. Return whether its place is known."""
        self.frames.choose(fixed)
        self.frames.refresh()
        message = framed(scan([1.0]), frame)
        stamp_ns = self.now_ns - self.age_ns
        message.header.stamp.sec, message.header.stamp.nanosec = divmod(stamp_ns, SECOND)
        self.shown.show(message)
        (item,) = self.shown.display.items.values()
        _, is_right = self.shown.pose("", item, self.frames)
        return is_right

    def sentence(self, fixed: str, frame: str) -> str:
        """Return what the display of a scan says that cannot be shown."""
        assert not self.shows(fixed, frame)
        (item,) = self.shown.display.items.values()
        self.shown.warning = self.frames.why(item.frame, item.stamp_ns, "/scan")
        sentence, is_warning = self.shown.sentence()
        assert is_warning
        return sentence

    def doctor(self, fixed: str, frame: str) -> str:
        """Return what the doctor says of everything, and of the two frames."""
        found = self.diagnosis.why(fixed, frame, now_ns=self.now_ns)
        problems = self.diagnosis.problems(now_ns=self.now_ns)
        both = [*problems, *([] if found is None else [found])]
        return "\n".join(_sentences(both, ()))


def nothing(robot: Robot) -> None:
    del robot


def two_trees(robot: Robot) -> None:
    robot.drive(("earth", "map"), ("odom", "base_link"))
    robot.fix("base_link", "laser")


def loop(robot: Robot) -> None:
    robot.drive(("a", "b"), ("b", "c"))
    robot.drive(("c", "a"), node="/wrong")
    robot.fix("map", "odom")


def two_parents(robot: Robot) -> None:
    robot.fix("base_footprint", "base_link", node="/robot_state_publisher")
    robot.drive(("odom", "base_link"))


def stale(robot: Robot) -> None:
    robot.fix("base_link", "laser")
    robot.drive(("odom", "base_link"))
    robot.wait(3.1)


def clock_ahead(robot: Robot) -> None:
    robot.drive(("odom", "base_link"))
    robot.age_ns = -8 * SECOND // 10


def mixed_time(robot: Robot) -> None:
    for tenth in range(20):
        robot.publish("odom", "base_link", node="/sim", stamp_ns=tenth * 10**8, x=tenth)
        robot.drive(("map", "odom"), seconds=0.1, node="/slam")
    robot.age_ns = SECOND // 10


def wrong_letter(robot: Robot) -> None:
    robot.fix("base_link", "laser")
    robot.drive(("odom", "base_link"))


def leading_slash(robot: Robot) -> None:
    robot.fix("/base_link", "laser")
    robot.drive(("odom", "base_link"))


def static_on_tf(robot: Robot) -> None:
    robot.publish("base_link", "laser", node="/mount")
    robot.drive(("odom", "base_link"), seconds=3)
    robot.age_ns = SECOND // 10


def namespace(robot: Robot) -> None:
    robot.fix("base_link", "laser", topic="/robot1/tf_static")
    robot.drive(("odom", "base_link"), topic="/robot1/tf")


def future(robot: Robot) -> None:
    for _ in range(4):
        robot.publish("odom", "base_link", x=robot.now_ns / SECOND % 1000)
        robot.wait(1)
    robot.age_ns = 3 * SECOND // 10


@dataclass
class Case:
    """Broken set-up, the frames of view and scan, and what is said."""

    make: Callable[[Robot], None]
    fixed: str
    frame: str
    cause: str
    advice: str
    is_for_doctor: bool = True  #: whether it can be seen without a scan

    @property
    def name(self) -> str:
        return self.make.__name__


CASES = [
    Case(nothing, "map", "laser", "nobody publishes on /tf", "zbot topic info -v /tf"),
    Case(two_trees, "map", "laser", "two trees; nobody publishes map -> odom", "AMCL or SLAM"),
    Case(loop, "map", "b", "a -> b -> c -> a is a loop", "zbot node info /wrong"),
    Case(two_parents, "odom", "base_footprint", "`base_link` has 2 parents", "zbot node info"),
    Case(stale, "odom", "laser", "was last heard 3.2 s ago", "zbot topic hz /tf"),
    Case(clock_ahead, "odom", "base_link", "clock is 0.8 s ahead", "zbot topic delay /scan", False),
    Case(mixed_time, "map", "base_link", "has simulated or recorded time", "use_sim_time"),
    Case(wrong_letter, "odom", "lazer", "did you mean 'laser'?", "write 'laser' in place of"),
    Case(leading_slash, "odom", "/laser", "begins with a slash", "write 'laser' in place"),
    Case(static_on_tf, "odom", "laser", "came only once", "static_transform_publisher"),
    Case(namespace, "odom", "laser", "are on /robot1/tf", "-r /tf:=/robot1/tf"),
    Case(future, "odom", "base_link", "newer than the newest transform", "timeout=", False),
]


@pytest.mark.parametrize(
    "case", [case for case in CASES if case.make is not leading_slash], ids=lambda case: case.name
)
def test_the_display_names_frames_cause_and_what_to_type(case: Case) -> None:
    robot = Robot()
    case.make(robot)
    sentence = robot.sentence(case.fixed, case.frame)
    problem, _, advice = sentence.partition("\n→ ")
    assert case.fixed in problem
    assert case.frame in problem
    assert case.cause in problem
    assert case.advice in advice


def test_the_display_takes_a_name_without_its_slash_as_rviz_does() -> None:
    robot = Robot()
    leading_slash(robot)
    robot.age_ns = SECOND // 5
    assert robot.shows("odom", "/laser")


@pytest.mark.parametrize(
    "case", [case for case in CASES if case.is_for_doctor], ids=lambda case: case.name
)
def test_the_doctor_says_the_same(case: Case) -> None:
    robot = Robot()
    case.make(robot)
    said = robot.doctor(case.fixed, case.frame)
    assert case.cause in said
    assert case.advice in said
