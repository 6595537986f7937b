import asyncio

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


async def spin(node):
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0)
        await asyncio.sleep(0.01)


async def main():
    rclpy.init()
    node = Node('beside_asyncio')
    heard = asyncio.Event()
    publisher = node.create_publisher(String, 'topic', 10)
    node.create_subscription(String, 'topic', lambda msg: heard.set(), 10)
    spinning = asyncio.create_task(spin(node))
    while not heard.is_set():
        publisher.publish(String(data='x'))
        await asyncio.sleep(0.05)
    print('heard in asyncio', flush=True)
    spinning.cancel()
    node.destroy_node()
    rclpy.shutdown()


asyncio.run(main())
