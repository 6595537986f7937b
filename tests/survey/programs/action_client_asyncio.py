"""Goals from asyncio, the node spun between its turns."""

import asyncio

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node


async def spinning(node):
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.01)
        await asyncio.sleep(0.001)


async def run(node):
    client = ActionClient(node, Fibonacci, 'fibonacci')
    client.wait_for_server()
    goal_handle = await client.send_goal_async(Fibonacci.Goal(order=4))
    response = await goal_handle.get_result_async()
    node.get_logger().info(f'Result: {list(response.result.sequence)}')


async def main():
    node = Node('asyncio_client')
    spin = asyncio.get_running_loop().create_task(spinning(node))
    work = asyncio.get_running_loop().create_task(run(node))
    await work
    spin.cancel()


rclpy.init()
asyncio.run(main())
rclpy.shutdown()
