import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.signals import SignalHandlerOptions

context = Context()
rclpy.init(context=context, signal_handler_options=SignalHandlerOptions.NO)
node = rclpy.create_node('own', context=context)
executor = SingleThreadedExecutor(context=context)
executor.add_node(node)
ticks = []
timer = node.create_timer(0.02, lambda: ticks.append(1))
while len(ticks) < 3:
    executor.spin_once(timeout_sec=1)
print('ticked', context.ok(), rclpy.ok(), timer.is_canceled(), flush=True)
executor.shutdown()
node.destroy_node()
rclpy.shutdown(context=context)
