"""asyncio beside rclpy: two goals awaited at once while another thread spins the node."""

import asyncio
import threading
from typing import Any

import rclpy
from rclpy.action import ActionClient
from rclpy.task import Future

from example_interfaces.action import Fibonacci
from std_msgs.msg import String


def in_asyncio(future: Future) -> "asyncio.Future[Any]":
    """Return an asyncio future that gets the result of one of rclpy."""
    loop = asyncio.get_running_loop()
    waiting = loop.create_future()
    future.add_done_callback(
        lambda done: loop.call_soon_threadsafe(waiting.set_result, done.result())
    )
    return waiting


async def grown(client: ActionClient, seasons: int) -> list[int]:
    handle = await in_asyncio(client.send_goal_async(Fibonacci.Goal(order=seasons)))
    answer = await in_asyncio(handle.get_result_async())
    return list(answer.result.sequence)


async def main() -> None:
    rclpy.init()
    node = rclpy.create_node("heath")
    loop, news = asyncio.get_running_loop(), asyncio.Queue()
    node.create_subscription(
        String, "news", lambda m: loop.call_soon_threadsafe(news.put_nowait, m.data), 10
    )
    publisher = node.create_publisher(String, "news", 10)
    client = ActionClient(node, Fibonacci, "breed")
    spinning = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
    spinning.start()
    await asyncio.to_thread(client.wait_for_server, 60)
    print(*await asyncio.gather(grown(client, 4), grown(client, 6)))
    publisher.publish(String(data="a litter was born"))
    print("news:", await asyncio.wait_for(news.get(), 60))
    await loop.run_in_executor(None, rclpy.shutdown)
    spinning.join(60)
    print("spinning", spinning.is_alive())


asyncio.run(main())
