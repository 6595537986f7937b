from launch import LaunchDescription
from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit


def generate_launch_description():
    once = ExecuteProcess(cmd=['echo', 'for once'], output='screen')
    return LaunchDescription([
        ExecuteProcess(cmd=['echo', 'again'], respawn=True, respawn_delay=0.1,
                       output='screen'),
        once,
        RegisterEventHandler(OnProcessExit(target_action=once, on_exit=[LogInfo(msg='once is over')])),
    ])
