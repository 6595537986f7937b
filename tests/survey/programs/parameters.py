import rclpy
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.node import Node
from rclpy.parameter import Parameter


class MinimalParam(Node):
    def __init__(self):
        super().__init__('minimal_param_node')
        my_parameter_descriptor = ParameterDescriptor(description='This parameter is mine!')
        self.declare_parameter('my_parameter', 'world', my_parameter_descriptor)
        self.declare_parameters(namespace='', parameters=[
            ('rate', 2.0, ParameterDescriptor(
                floating_point_range=[FloatingPointRange(from_value=0.1, to_value=10.0, step=0.0)])),
            ('names', ['a', 'b']),
            ('flag', Parameter.Type.BOOL),
        ])
        self.add_on_set_parameters_callback(self.parameter_callback)
        self.timer = self.create_timer(0.2, self.timer_callback)

    def parameter_callback(self, params):
        for param in params:
            if param.name == 'my_parameter' and param.type_ == Parameter.Type.STRING:
                self.get_logger().info(f'set to {param.value}')
        return SetParametersResult(successful=True)

    def timer_callback(self):
        my_param = self.get_parameter('my_parameter').get_parameter_value().string_value
        rate = self.get_parameter('rate').value
        self.get_logger().info('Hello %s! %.1f %s' % (my_param, rate, self.has_parameter('flag')))
        try:
            self.get_parameter('nothing')
        except ParameterNotDeclaredException:
            pass
        my_new_param = rclpy.parameter.Parameter(
            'my_parameter', rclpy.Parameter.Type.STRING, 'world')
        self.set_parameters([my_new_param])


def main():
    rclpy.init()
    node = MinimalParam()
    rclpy.spin(node)


if __name__ == '__main__':
    main()
