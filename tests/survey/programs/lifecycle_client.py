import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState

rclpy.init()
node = rclpy.create_node('lc_client')
change = node.create_client(ChangeState, '/lc_talker/change_state')
get = node.create_client(GetState, '/lc_talker/get_state')
change.wait_for_service()
for transition in (Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE):
    future = change.call_async(ChangeState.Request(transition=Transition(id=transition)))
    rclpy.spin_until_future_complete(node, future)
    print('changed', future.result().success)
future = get.call_async(GetState.Request())
rclpy.spin_until_future_complete(node, future)
print('state', future.result().current_state.label, flush=True)
rclpy.shutdown()
