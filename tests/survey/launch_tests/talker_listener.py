"""A test of a launch, as courses write it; `test_launch_tests.py` runs it."""

import sys
import time
import unittest
import uuid

import launch
import launch_ros.actions
import launch_testing.actions
import launch_testing.asserts
import launch_testing.markers
import launch_testing_ros
import pytest
import rclpy
from launch_testing.tools import launch_process

import std_msgs.msg

HELPER = """
import signal
signal.signal(signal.SIGINT, lambda *_: exit(0))
print("ready", flush=True)
signal.pause()
"""


@pytest.mark.launch_test
@launch_testing.markers.keep_alive
@launch_testing.parametrize("greeting", ["hello"])
def generate_test_description(greeting):
    talker = launch_ros.actions.Node(
        package="zbot_nodes",
        executable="talker",
        remappings=[("chatter", "talker_chatter")],
    )
    listener = launch_ros.actions.Node(
        package="zbot_nodes",
        executable="listener",
        remappings=[("chatter", "listener_chatter")],
    )
    passing = launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", f"print('{greeting}')"])
    return (
        launch.LaunchDescription([talker, listener, passing, launch_testing.actions.ReadyToTest()]),
        {"talker": talker, "listener": listener, "passing": passing},
    )


class TestTalkerListener(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rclpy.init()

    @classmethod
    def tearDownClass(cls):
        rclpy.shutdown()

    def setUp(self, talker):
        self.proc_info.assertWaitForStartup(talker, timeout=10)
        self.node = rclpy.create_node("test_talker_listener")

    def tearDown(self):
        self.node.destroy_node()

    def test_talker_transmits(self, talker, proc_output):
        received = []
        self.node.create_subscription(std_msgs.msg.String, "talker_chatter", received.append, 10)
        end_time = time.time() + 10
        while len(received) < 2 and time.time() < end_time:
            rclpy.spin_once(self.node, timeout_sec=0.1)
        self.assertGreater(len(received), 1)
        for message in received:
            proc_output.assertWaitFor(message.data, process=talker, timeout=5, stream="stderr")

    def test_listener_receives(self, listener, proc_output):
        publisher = self.node.create_publisher(std_msgs.msg.String, "listener_chatter", 10)
        message = std_msgs.msg.String(data=str(uuid.uuid4()))
        for _ in range(20):
            publisher.publish(message)
            if proc_output.waitFor(message.data, process=listener, timeout=0.5):
                return
        self.fail("the listener did not hear")

    def test_topics_have_messages(self):
        topics = [("talker_chatter", std_msgs.msg.String)]
        with launch_testing_ros.WaitForTopics(topics, timeout=10.0) as waiter:
            self.assertEqual(waiter.topics_received(), {"talker_chatter"})
            self.assertTrue(waiter.received_messages("talker_chatter"))

    def test_a_process_ends_by_itself(self, passing, proc_info, greeting):
        proc_info.assertWaitForShutdown(passing, timeout=10)
        self.assertEqual(proc_info[passing].returncode, 0)
        self.assertEqual(greeting, "hello")
        self.proc_output.assertWaitFor("hello", process=passing)

    def test_a_process_can_be_added(self, launch_service, proc_info, proc_output):
        action = launch.actions.ExecuteProcess(cmd=[sys.executable, "-c", HELPER])
        with launch_process(launch_service, action, proc_info, proc_output) as helper:
            assert helper.wait_for_output(lambda text: "ready" in text, timeout=10)
            assert helper.running
        assert helper.wait_for_shutdown(timeout=10)
        self.assertEqual(helper.exit_code, 0)


@launch_testing.post_shutdown_test()
class TestAfterShutdown(unittest.TestCase):
    def test_exit_codes(self, proc_info):
        # Programs that catch no KeyboardInterrupt die of SIGINT, as Python's do.
        codes = [launch_testing.asserts.EXIT_OK, launch_testing.asserts.EXIT_SIGINT]
        launch_testing.asserts.assertExitCodes(proc_info, codes)

    def test_output(self, proc_output, passing):
        launch_testing.asserts.assertInStdout(proc_output, "hello", passing)
