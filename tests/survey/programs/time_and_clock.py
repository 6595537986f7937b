import rclpy
from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from rclpy.time import Time

rclpy.init()
node = rclpy.create_node('clock')
start = node.get_clock().now()
node.get_clock().sleep_for(Duration(seconds=0.05))
passed = node.get_clock().now() - start
print('passed', passed >= Duration(nanoseconds=50_000_000), passed.nanoseconds > 5e7)
stamp = (start + Duration(seconds=1.5)).to_msg()
print(Time.from_msg(stamp) > Time.from_msg(start.to_msg()), start.seconds_nanoseconds()[1] >= 0)
print(Clock(clock_type=ClockType.STEADY_TIME).now().clock_type == ClockType.STEADY_TIME, flush=True)
rclpy.shutdown()
