import threading

import rclpy
from std_msgs.msg import String


def main():
    rclpy.init()
    node = rclpy.create_node('loop')
    publisher = node.create_publisher(String, 'topic', 10)
    thread = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
    thread.start()
    rate = node.create_rate(20)
    i = 0
    try:
        while rclpy.ok():
            publisher.publish(String(data=f'Hello World: {i}'))
            node.get_logger().info(f'Publishing: "{i}"')
            i += 1
            rate.sleep()
    except KeyboardInterrupt:
        pass
    rclpy.shutdown()
    thread.join()


main()
