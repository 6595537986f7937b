"""Bell tower: a guard condition rings from a thread, and coroutines wait for the strokes."""

import threading

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future


class Tower(Node):
    def __init__(self) -> None:
        super().__init__("tower")
        self.strokes: list[str] = []
        self.rung = Future()
        self.rope = self.create_guard_condition(self.ring, ReentrantCallbackGroup())
        self.create_timer(0.01, self.tick, callback_group=ReentrantCallbackGroup())
        self.ticks = 0

    def ring(self) -> None:
        self.rung.set_result("clang")

    async def tick(self) -> None:
        self.ticks += 1
        await self.rung

    async def listen(self, name: str) -> str:
        self.strokes.append(f"{name} listens")
        sound = await self.rung
        self.strokes.append(f"{name} heard {sound}")
        return name


rclpy.init()
tower = Tower()
executor = SingleThreadedExecutor()
executor.add_node(tower)
tasks = [executor.create_task(tower.listen, name) for name in ("monk", "owl")]
while tower.ticks < 3:
    executor.spin_once(timeout_sec=1)
print("waiting", tower.strokes, [task.done() for task in tasks])
threading.Thread(target=tower.rope.trigger).start()
executor.spin_until_future_complete(tasks[1], timeout_sec=60)
print("after", tower.strokes[2:], [task.result() for task in tasks])
executor.shutdown()
rclpy.shutdown()
