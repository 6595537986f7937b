import rclpy

rclpy.init()
node = rclpy.create_node('guarded')
guard = node.create_guard_condition(lambda: print('triggered', flush=True))
guard.trigger()
rclpy.spin_once(node, timeout_sec=1)
rclpy.shutdown()
