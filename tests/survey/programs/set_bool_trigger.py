import rclpy
from rclpy.node import Node
from std_srvs.srv import SetBool, Trigger
from std_srvs.srv._trigger import Trigger_Request, Trigger_Response


class Motor(Node):
    def __init__(self):
        super().__init__('motor')
        self.enabled = False
        self.service = self.create_service(SetBool, 'enable', self.enable)
        self.create_service(Trigger, 'status', self.status)

    def enable(self, request: SetBool.Request, response: SetBool.Response):
        self.enabled = request.data
        response.success = True
        response.message = 'on' if request.data else 'off'
        return response

    def status(self, request: Trigger_Request, response: Trigger_Response):
        response.success = self.enabled
        response.message = 'motor is ' + ('on' if self.enabled else 'off')
        return response


def main():
    rclpy.init()
    node = Motor()
    client = node.create_client(SetBool, 'enable')
    future = client.call_async(SetBool.Request(data=True))
    rclpy.spin_until_future_complete(node, future)
    node.get_logger().info(future.result().message)
    status = node.create_client(Trigger, 'status').call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, status)
    node.get_logger().info(status.result().message)
    rclpy.shutdown()


main()
