import array

import rclpy
from std_msgs.msg import ColorRGBA, Float64MultiArray, Header, MultiArrayDimension

rclpy.init()
msg = Float64MultiArray(data=[1, 2.5])
msg.layout.dim.append(MultiArrayDimension(label='x', size=2, stride=2))
print(type(msg.data) is array.array, msg.data[1], Header(frame_id='map').frame_id,
      ColorRGBA.get_fields_and_field_types()['r'], flush=True)
try:
    Header(frame_id=3)
except (AssertionError, TypeError) as error:
    print('refused', flush=True)
rclpy.shutdown()
