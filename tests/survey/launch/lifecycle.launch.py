from launch import LaunchDescription
from launch.actions import EmitEvent, LogInfo, RegisterEventHandler
from launch_ros.actions import LifecycleNode
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from launch.events import matches_action
import lifecycle_msgs.msg


def generate_launch_description():
    talker = LifecycleNode(
        name='talker', namespace='', package='lifecycle', executable='lifecycle_talker', output='screen')
    configure = EmitEvent(event=ChangeState(
        lifecycle_node_matcher=matches_action(talker),
        transition_id=lifecycle_msgs.msg.Transition.TRANSITION_CONFIGURE))
    return LaunchDescription([
        talker,
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=talker, goal_state='inactive',
            entities=[LogInfo(msg='the talker is configured')])),
        configure,
    ])
