import rclpy
from example_interfaces.srv import AddTwoInts

rclpy.init()
node = rclpy.create_node('polling')
cli = node.create_client(AddTwoInts, 'add_two_ints')
cli.wait_for_service()
future = cli.call_async(AddTwoInts.Request(a=41, b=1))
while rclpy.ok():
    rclpy.spin_once(node)
    if future.done():
        try:
            result = future.result()
        except Exception as e:
            node.get_logger().info('Service call failed %r' % (e,))
        else:
            node.get_logger().info('Result of add_two_ints: for %d + %d = %d' % (41, 1, result.sum))
        break
node.destroy_node()
rclpy.shutdown()
