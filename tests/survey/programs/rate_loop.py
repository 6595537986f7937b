import threading

import rclpy
from rclpy.exceptions import ROSInterruptException
from std_msgs.msg import Int32

rclpy.init()
node = rclpy.create_node('rate_loop')
publisher = node.create_publisher(Int32, 'count', 10)
thread = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
thread.start()
rate = node.create_rate(20)
count = 0
try:
    while rclpy.ok() and count < 5:
        publisher.publish(Int32(data=count))
        count += 1
        rate.sleep()
except (KeyboardInterrupt, ROSInterruptException):
    pass
print('counted to', count, flush=True)
rclpy.shutdown()
thread.join()
