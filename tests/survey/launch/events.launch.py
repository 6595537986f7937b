from launch import LaunchDescription
from launch.actions import (EmitEvent, ExecuteProcess, LogInfo, OpaqueFunction,
                            RegisterEventHandler, TimerAction)
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart
from launch.events import Shutdown
from launch_ros.actions import Node


def generate_launch_description():
    node = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    spawn = ExecuteProcess(
        cmd=[['ros2 service call ', '/spawn ', 'turtlesim/srv/Spawn ', '"{x: 2, y: 2, theta: 0.2}"']],
        shell=True)
    return LaunchDescription([
        node,
        RegisterEventHandler(OnProcessStart(
            target_action=node, on_start=[LogInfo(msg='Turtlesim started, spawning turtle'), spawn])),
        RegisterEventHandler(OnProcessIO(
            target_action=spawn,
            on_stdout=lambda event: LogInfo(msg='Spawn request says "{}"'.format(
                event.text.decode().strip())))),
        RegisterEventHandler(OnExecutionComplete(
            target_action=spawn,
            on_completion=[LogInfo(msg='Spawn finished'),
                           TimerAction(period=0.2, actions=[EmitEvent(event=Shutdown(reason='all done'))])])),
    ])
