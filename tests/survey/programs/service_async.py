"""A server whose handler is a coroutine."""

import rclpy
from example_interfaces.srv import AddTwoInts


async def add(request, response):
    response.sum = request.a + request.b
    node.get_logger().info('answered')
    return response


with rclpy.init():
    node = rclpy.create_node('minimal_service')
    node.create_service(srv_type=AddTwoInts, srv_name='add_two_ints', callback=add)
    rclpy.spin(node)
