"""Publisher whose timer calls a nested function."""

import rclpy
from std_msgs.msg import String


def main(args=None):
    rclpy.init(args=args)
    node = rclpy.create_node('minimal_publisher')
    publisher = node.create_publisher(msg_type=String, topic='topic', qos_profile=10)
    i = 0

    def timer_callback():
        nonlocal i
        i += 1
        publisher.publish(String(data=f'Hello World: {i}'))
        node.get_logger().info(f'Publishing {i}')

    timer = node.create_timer(timer_period_sec=0.1, callback=timer_callback)
    rclpy.spin(node)
    node.destroy_timer(timer)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
