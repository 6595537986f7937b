"""Client of a service and of an action, which calls both again and again.

Run:     soak_client.py
Calls:   add_two_ints (example_interfaces/srv/AddTwoInts), every 0.1 s
Goals:   fibonacci (action_tutorials_interfaces/action/Fibonacci), one after the other

Prints lines of JSON: `failed` for each wrong or missing answer, and `end` with the numbers.
"""

from __future__ import annotations

import contextlib
import json
import threading
import time
from typing import Any

import zbot
from zbot.action import ActionClient
from zbot.errors import ZbotError

from action_tutorials_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts

_PATIENCE_S = 20.0


def say(**facts: Any) -> None:
    print(json.dumps({"time": time.monotonic(), **facts}), flush=True)


class SoakClient(zbot.Node):
    def __init__(self) -> None:
        super().__init__("soak_client")
        self.sums = self.create_client(AddTwoInts, "add_two_ints")
        self.actions = ActionClient[Any, Any, Any](self, Fibonacci, "fibonacci")
        self.calls = self.goals = 0
        self.is_over = threading.Event()

    def call(self) -> None:
        self.sums.wait_for_service(_PATIENCE_S)
        while not self.is_over.wait(0.1):
            request = AddTwoInts.Request(a=self.calls, b=1)
            answer = self.sums.call(request, timeout_sec=_PATIENCE_S)
            if answer.sum != self.calls + 1:
                say(kind="failed", sum=answer.sum, calls=self.calls)
            self.calls += 1

    def send(self) -> None:
        self.actions.wait_for_server(_PATIENCE_S)
        while not self.is_over.wait(0.1):
            response = self.actions.send_goal(Fibonacci.Goal(order=3))
            if list(response.result.sequence) != [0, 1, 1, 2]:
                say(kind="failed", sequence=list(response.result.sequence))
            self.goals += 1

    def guarded(self, work: Any) -> None:
        try:
            work()
        except ZbotError as error:
            if not self.is_over.is_set() and self.context.ok():
                say(kind="failed", error=str(error))


def main() -> None:
    with zbot.init():
        node = SoakClient()
        threads = [
            threading.Thread(target=node.guarded, args=(work,), daemon=True)
            for work in (node.call, node.send)
        ]
        for thread in threads:
            thread.start()
        with contextlib.suppress(zbot.ExternalShutdownException, KeyboardInterrupt):
            zbot.spin(node)
        node.is_over.set()
    say(kind="end", calls=node.calls, goals=node.goals)


if __name__ == "__main__":
    main()
