"""Spin in a thread; the main one works with what arrived."""

import threading

import rclpy
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import String


def main():
    rclpy.init()
    node = rclpy.create_node('threaded')
    arrived = threading.Event()
    node.create_subscription(String, 'topic', lambda msg: arrived.set(), 10)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    print('arrived', arrived.wait(10), flush=True)
    executor.shutdown()
    thread.join()
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
