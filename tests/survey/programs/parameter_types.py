import rclpy
from rclpy.parameter import Parameter

rclpy.init()
node = rclpy.create_node(
    'types', allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True)
node.set_parameters([
    Parameter('a', Parameter.Type.BOOL, True),
    rclpy.Parameter('b', rclpy.Parameter.Type.INTEGER_ARRAY, [1, 2]),
    Parameter('c', Parameter.Type.STRING_ARRAY, ['x', 'y']),
    Parameter('d.e', value=2.5),
])
values = [node.get_parameter(name).value for name in 'ab'] + [node.get_parameter('c').value]
print(values[0], list(values[1]), list(values[2]), node.get_parameters_by_prefix('d')['e'].value)
print(node.get_parameter('b').type_.name, node.has_parameter('zzz'), flush=True)
rclpy.shutdown()
