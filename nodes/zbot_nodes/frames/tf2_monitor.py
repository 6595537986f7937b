"""Print how late transforms arrive, and how often.

Run:        zbot run tf2_ros tf2_monitor [FRAME_A FRAME_B]
Subscribes: /tf and /tf_static (tf2_msgs/TFMessage)
"""

from __future__ import annotations

import sys
from collections import defaultdict, deque
from typing import Any

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.tf2 import Buffer, TransformException
from zbot.tf2.diagnosis import TransformMonitor
from zbot_nodes.startup.program import run_node

from tf2_msgs.msg import TFMessage

_KEPT = 1000  #: measurements of each frame
_DEPTH = 100
_LOOK_S = 0.5
_GATHER_S = 10.0
_NOBODY = "<no authority available>"


class TF2Monitor(zbot.Node):
    """Measures the age of transforms when they arrive.

    Args:
        chain: Two frames, or nothing for all frames.
        options: The options of `zbot.Node`.
    """

    def __init__(self, chain: tuple[str, str] | None = None, **options: Any) -> None:
        super().__init__("tf2_monitor_main", **options)
        self.chain = chain
        self.buffer = Buffer()
        self.monitor = TransformMonitor(self, self.buffer)
        self.delays: dict[str, deque[float]] = defaultdict(lambda: deque(maxlen=_KEPT))
        self.message_delays: deque[float] = deque(maxlen=_KEPT)
        self.times_s: deque[float] = deque(maxlen=_KEPT)
        self.net_delays: deque[float] = deque(maxlen=_KEPT)
        kept = QoSProfile(depth=_DEPTH, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(TFMessage, "/tf", self.measure, _DEPTH)
        self.create_subscription(TFMessage, "/tf_static", self.measure, kept)
        real = zbot.Clock(clock_type=zbot.ClockType.STEADY_TIME)
        self.create_timer(_LOOK_S, self.look, clock=real)
        self.create_timer(_GATHER_S, self.show, clock=real)
        what = "all frames" if chain is None else f"{chain[0]} -> {chain[1]}"
        print(f"Gathering data on {what} for 10 seconds...", flush=True)

    def now_s(self) -> float:
        """Return the present time."""
        return self.get_clock().now().nanoseconds / 1e9

    def measure(self, message: TFMessage) -> None:
        """Store the ages of the transforms in a message."""
        now_s = self.now_s()
        ages = []
        for transform in message.transforms:
            ages.append(now_s - transform.header.stamp.sec - transform.header.stamp.nanosec / 1e9)
            self.delays[transform.child_frame_id].append(ages[-1])
        self.message_delays.append(sum(ages) / max(1, len(ages)))
        self.times_s.append(now_s)

    def look(self) -> None:
        """Store the age of the transform between the two frames."""
        if self.chain is None:
            return
        try:
            found = self.buffer.lookup_transform(*self.chain, zbot.Time())
        except TransformException as error:
            text = f"Waiting for transform {self.chain[0]} ->  {self.chain[1]}: {error}"
            text += self.monitor.explanation(*self.chain)
            self.get_logger().info(text, throttle_duration_sec=1.0)
            return
        stamp = found.header.stamp
        self.net_delays.append(self.now_s() - stamp.sec - stamp.nanosec / 1e9)

    def frames(self) -> list[str]:
        """Return the frames to report: all frames, or the frames between the two frames."""
        if self.chain is None:
            return sorted(self.delays)
        way = frames_between(self.buffer, *self.chain)
        return [frame for frame in way if frame in self.delays]

    def report(self) -> str:
        """Return the measurements as text."""
        lines = ["", "", ""]
        if self.chain is None:
            lines.append("RESULTS: for all Frames")
        else:
            lines.append(f"RESULTS: for {self.chain[0]} to {self.chain[1]}")
            lines.append(f"Chain is: {' -> '.join(frames_between(self.buffer, *self.chain))}")
            mean, worst = _mean_and_worst(self.net_delays)
            lines.append(f"Net delay     avg = {mean:.6g}: max = {worst:.6g}")
        lines += ["", "Frames:"]
        for name in self.frames():
            mean, worst = _mean_and_worst(self.delays[name])
            text = f"Average Delay: {mean:.6g}, Max Delay: {worst:.6g}"
            lines.append(f"Frame: {name}, published by {_NOBODY}, {text}")
        lines += ["", "All Broadcasters:"]
        if self.times_s:
            rate_hz = len(self.times_s) / max(1e-8, self.times_s[-1] - self.times_s[0])
            mean, worst = _mean_and_worst(self.message_delays)
            text = f"{rate_hz:.6g} Hz, Average Delay: {mean:.6g} Max Delay: {worst:.6g}"
            lines.append(f"Node: {_NOBODY} {text}")
        return "\n".join([*lines, *self.problems()])

    def problems(self) -> list[str]:
        """Return the sentences about what is wrong, as `zbot doctor --tf` says them."""
        if self.chain is None:
            found = self.monitor.diagnosis.problems()
        else:
            reason = self.monitor.diagnosis.why(*self.chain)
            found = [] if reason is None else [reason]
        if not found:
            return []
        return ["", "Problems:", *map(str, found)]

    def show(self) -> None:
        """Print the measurements."""
        print(self.report(), flush=True)


def frames_between(buffer: Buffer, first: str, last: str) -> list[str]:
    """Return the frames on the way between two frames, both included."""
    parents = dict(_parents(buffer))
    up, down = _ancestors(parents, first), _ancestors(parents, last)
    common = next((frame for frame in up if frame in down), None)
    if common is None:
        return []
    return [*up[: up.index(common) + 1], *reversed(down[: down.index(common)])]


def _parents(buffer: Buffer) -> list[tuple[str, str]]:
    found = []
    for line in buffer.all_frames_as_string().splitlines():
        child, _, parent = (
            line.removeprefix("Frame ").removesuffix(".").partition(" exists with parent ")
        )
        found.append((child, parent))
    return found


def _ancestors(parents: dict[str, str], name: str) -> list[str]:
    found = [name]
    while found[-1] in parents and len(found) <= len(parents):
        found.append(parents[found[-1]])
    return found


def _mean_and_worst(values: deque[float]) -> tuple[float, float]:
    return sum(values) / max(1, len(values)), max(values, default=0.0)


def main() -> None:
    """Run until Ctrl-C."""
    words = remove_ros_args()[1:]
    if len(words) not in {0, 2}:
        sys.exit("TF_Monitor: usage: tf2_monitor framea frameb")
    chain = (words[0], words[1]) if words else None
    run_node(lambda: TF2Monitor(chain))


if __name__ == "__main__":
    main()
