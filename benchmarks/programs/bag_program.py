"""Publishers and a subscriber for the measurements of bags. They print one line of JSON each.

send TOPICS RATE SECONDS SIZE   publishes on /load_0, /load_1 ... at a rate for all together
listen TOPICS SECONDS           measures when messages of /load_0 ... come
"""

from __future__ import annotations

import gc
import json
import sys
import time

import zbot
from zbot.qos import QoSProfile

from sensor_msgs.msg import Image
from std_msgs.msg import String

LARGE_BYTES = 10_000


def message(size: int, number: int) -> Image | String:
    """Return a message of a size in bytes that contains its number."""
    if size >= LARGE_BYTES:
        image = Image(height=1, width=size, step=size, data=bytes(size))
        image.header.frame_id = str(number)
        return image
    return String(data=f"{number} ".ljust(size - 8, "x"))


def send(topics: int, rate: float, seconds: float, size: int) -> None:
    """Publish numbered messages. They are sent in bursts of a millisecond at high rates."""
    zbot.init()
    node = zbot.Node(f"load_{size}")
    kind = Image if size >= LARGE_BYTES else String
    names = [f"/load_{size}_{number}" for number in range(topics)]
    publishers = [node.create_publisher(kind, name, QoSProfile(depth=1000)) for name in names]
    print(json.dumps({"ready": names}), flush=True)
    sys.stdin.readline()
    counts = [0] * topics
    start, total = time.perf_counter(), 0
    while (now := time.perf_counter() - start) < seconds:
        due = int(now * rate)
        if total >= due:
            time.sleep(min(0.001, 1 / rate))
        while total < due:
            topic = total % topics
            publishers[topic].publish(message(size, counts[topic]))
            counts[topic] += 1
            total += 1
            # Without this, a sender that is too slow would never look at the clock.
            if time.perf_counter() - start > seconds:
                break
    print(json.dumps(dict(zip(names, counts, strict=True))), flush=True)
    sys.stdin.readline()
    zbot.shutdown()


def listen(topics: int, seconds: float) -> None:
    """Print the arrival times of messages, whose texts are planned times in seconds."""
    zbot.init()
    node = zbot.Node("timing")
    found: list[tuple[float, float]] = []

    def hear(text: String) -> None:
        found.append((float(text.data), time.perf_counter()))

    for number in range(topics):
        node.create_subscription(String, f"/timing_{number}", hear, 1000)
    done: zbot.Future[None] = zbot.Future()
    node.create_timer(seconds, lambda: done.set_result(None))
    gc.disable()  # the list gets long, and a search for garbage in it would delay the times
    print(json.dumps({"ready": True}), flush=True)
    zbot.spin_until_future_complete(node, done)
    print(json.dumps(found), flush=True)
    zbot.shutdown()


if __name__ == "__main__":
    words = sys.argv[2:]
    if sys.argv[1] == "send":
        send(int(words[0]), float(words[1]), float(words[2]), int(words[3]))
    else:
        listen(int(words[0]), float(words[1]))
