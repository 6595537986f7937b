"""Postcards: what messages take and refuse, as bytes, and published as bytes."""

from array import array

import rclpy
from rclpy.serialization import deserialize_message, serialize_message

from geometry_msgs.msg import Point, PoseWithCovarianceStamped
from std_msgs.msg import Int16MultiArray, String

card = PoseWithCovarianceStamped()
card.header.frame_id = "post"
card.pose.pose.position = Point(x=1.5, y=-2.0)
card.pose.covariance[7] = 0.25
print(card.pose.pose.position, len(card.pose.covariance), card.pose.covariance[7])
print(card.get_fields_and_field_types()["pose"], String.SLOT_TYPES[0].__class__.__name__)
for wrong in (lambda: String(data=5), lambda: String(text=""), lambda: setattr(card, "stamp", 1)):
    try:
        wrong()
        print("taken")
    except (AssertionError, AttributeError, TypeError) as error:
        print("refused", type(error).__name__)
data = serialize_message(Int16MultiArray(data=[1, -2]))
again = deserialize_message(data, Int16MultiArray)
print(data[:4].hex(), again.data == array("h", [1, -2]), again == Int16MultiArray(data=[1, -3]))
print(deserialize_message(serialize_message(card), PoseWithCovarianceStamped) == card)

rclpy.init()
node = rclpy.create_node("post_office")
arrived = rclpy.Future()
node.create_subscription(String, "cards", lambda card: arrived.set_result(card.data), 10)
publisher = node.create_publisher(String, "cards", 10)
publisher.publish(serialize_message(String(data="wish you were here")))
rclpy.spin_until_future_complete(node, arrived, timeout_sec=60)
print(arrived.result())
rclpy.shutdown()
