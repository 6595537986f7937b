import rclpy
from rclpy.exceptions import InvalidNodeNameException, InvalidTopicNameException
from rclpy.expand_topic_name import expand_topic_name
from rclpy.node import Node
from rclpy.validate_node_name import validate_node_name
from std_msgs.msg import String

rclpy.init()
node = Node('turtle', namespace='zoo')
publisher = node.create_publisher(String, '~/status', 1)
print(node.get_name(), node.get_namespace(), node.get_fully_qualified_name())
print(publisher.topic_name, node.resolve_topic_name('food'), expand_topic_name('a', 'n', '/ns'))
print(validate_node_name('good'), node.count_publishers('/zoo/turtle/status'))
for wrong, make in (
    (InvalidNodeNameException, lambda: Node('bad name')),
    (InvalidTopicNameException, lambda: node.create_publisher(String, 'a b', 1)),
):
    try:
        make()
    except wrong as e:
        print('refused:', type(e).__mro__[-1].__name__)
print('names are done', flush=True)
rclpy.shutdown()
