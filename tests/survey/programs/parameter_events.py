import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_event_handler import ParameterEventHandler


class Watcher(Node):
    def __init__(self):
        super().__init__('watcher')
        self.declare_parameter('gain', 1)
        self.handler = ParameterEventHandler(self)
        self.watched = self.handler.add_parameter_callback(
            parameter_name='gain', node_name='watcher', callback=self.changed)
        self.timer = self.create_timer(0.2, self.change)

    def change(self):
        self.set_parameters([Parameter('gain', value=self.get_parameter('gain').value + 1)])

    def changed(self, parameter):
        self.get_logger().info(f'gain is {parameter_value_to_python(parameter.value)}')


rclpy.init()
rclpy.spin(Watcher())
