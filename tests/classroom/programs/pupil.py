"""A pupil's node: says a number to its neighbour, and counts what it hears.

Run:        pupil.py NAME NEIGHBOUR [--hz 10]
Publishes:  NAME/words (std_msgs/String), a number and the monotonic time in nanoseconds
Subscribes: NEIGHBOUR/words

Prints `node TIME` when its node exists, with the time at which its making began, `hears TIME` with
the first message, `gap FIRST NEXT` when numbers are missing, and when it is interrupted a line of
JSON: received, lost, delays_us.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import time

import zbot

from std_msgs.msg import String


class Pupil(zbot.Node):
    def __init__(self, name: str, neighbour: str, hz: float) -> None:
        begun_ns = time.monotonic_ns()
        super().__init__(name)
        print("node", begun_ns, flush=True)
        self.said = 0
        self.heard: int | None = None
        self.lost = 0
        self.delays_us: list[int] = []
        self.words = self.create_publisher(String, f"{name}/words", 10)
        self.create_subscription(String, f"{neighbour}/words", self.on_words, 10)
        self.create_timer(1 / hz, self.speak)

    def speak(self) -> None:
        self.said += 1
        self.words.publish(String(data=f"{self.said} {time.monotonic_ns()}"))

    def on_words(self, msg: String) -> None:
        now = time.monotonic_ns()
        number, sent_ns = map(int, msg.data.split())
        if self.heard is None:
            print("hears", now, flush=True)
        elif number != self.heard + 1:
            self.lost += number - self.heard - 1
            print("gap", self.heard, number, flush=True)
        self.heard = number
        self.delays_us.append((now - sent_ns) // 1000)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("name")
    parser.add_argument("neighbour")
    parser.add_argument("--hz", type=float, default=10)
    options, _ = parser.parse_known_args()
    with zbot.init():
        pupil = Pupil(options.name, options.neighbour, options.hz)
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(pupil)
        print(
            json.dumps(
                {
                    "received": len(pupil.delays_us),
                    "lost": pupil.lost,
                    "delays_us": pupil.delays_us,
                }
            ),
            flush=True,
        )


if __name__ == "__main__":
    main()
