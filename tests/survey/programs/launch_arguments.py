import argparse
import sys

import rclpy
from rclpy.node import Node
from rclpy.utilities import remove_ros_args


def main(argv=sys.argv):
    rclpy.init(args=argv)
    args_without_ros = remove_ros_args(argv)
    parser = argparse.ArgumentParser()
    parser.add_argument('--count', type=int, default=1)
    args = parser.parse_args(args_without_ros[1:])
    node = Node('with_args')
    node.declare_parameter('speed', 1.0)
    print(args.count, node.get_parameter('speed').value, node.get_name(), flush=True)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
