"""Tests of the threads that a node has."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.conftest import Start

#: Waits until the checks of the start are over.
IDLE = """
import os, threading, time
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger

rclpy.init()
node = Node("idle")
for number in range({topics}):
    node.create_subscription(String, f"topic_{{number}}", print, 10)
node.create_client(Trigger, "ask")
node.create_service(Trigger, "answer", lambda _, answer: answer)
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(node)
end = time.monotonic() + 30
while threading.active_count() > 1 and time.monotonic() < end:
    executor.spin_once(timeout_sec=0.1)
print([thread.name for thread in threading.enumerate()])
tasks = "/proc/self/task"
print(len(os.listdir(tasks)) if os.path.isdir(tasks) else 0)
rclpy.shutdown()
"""


@pytest.mark.parametrize("topics", [10, pytest.param(500, marks=pytest.mark.timeout(120))])
def test_an_idle_node_has_only_the_main_thread_and_zenohs(start: Start, topics: int) -> None:
    program = start(source=IDLE.format(topics=topics))
    assert program.wait(60) == 0
    assert program.lines[-2] == "['MainThread']"
    if sys.platform == "linux":
        assert int(program.lines[-1]) < 60
