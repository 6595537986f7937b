"""Test cases beside a probe and a mill, for each kind of grain; `zbot test` and pytest run them."""

# ruff: noqa: PT009, PT027 - the test cases are those of unittest

import sys
import unittest
from pathlib import Path
from typing import Any

import launch_testing
import launch_testing.asserts
import pytest
import rclpy
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_testing.actions import ReadyToTest
from launch_testing.tools import launch_process
from launch_testing_ros import WaitForTopics

from std_msgs.msg import Float64

PROBE = Path(__file__).parents[1] / "greenhouse_probe.py"


def python(name: str, text: str) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", text], name=name)


@pytest.mark.launch_test
@launch_testing.parametrize("grain", ["rye", "oats"])
def generate_test_description(grain: str) -> tuple[LaunchDescription, dict[str, Any]]:
    mill = python("mill", f"print('stones turn')\nprint('{grain} is ground')")
    probe = ExecuteProcess(cmd=["zbot", "run", str(PROBE)], name="probe")
    return LaunchDescription([mill, probe, ReadyToTest()]), {"mill": mill, "probe": probe}


class TestMill(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        rclpy.init()
        cls.node = rclpy.create_node("miller")

    @classmethod
    def tearDownClass(cls) -> None:
        cls.node.destroy_node()
        rclpy.shutdown()

    def test_the_probe_measures(self, probe: ExecuteProcess, proc_info: Any) -> None:
        proc_info.assertWaitForStartup(probe, timeout=60)
        measured = rclpy.Future()
        self.node.create_subscription(Float64, "humidity", measured.set_result, 10)
        rclpy.spin_until_future_complete(self.node, measured, timeout_sec=60)
        self.assertEqual(measured.result().data, 49.0)

    def test_the_topic_has_messages(self) -> None:
        with WaitForTopics([("humidity", Float64)], timeout=60) as waiting:
            self.assertEqual(waiting.topics_received(), {"humidity"})
            self.assertEqual(waiting.received_messages("humidity")[0].data, 49.0)

    def test_the_mill_stops(self, mill: ExecuteProcess, proc_info: Any, grain: str) -> None:
        proc_info.assertWaitForShutdown(mill, timeout=60)
        self.proc_output.assertWaitFor(f"{grain} is ground", process=mill, timeout=60)
        with self.assertRaises(AssertionError):
            self.proc_output.assertWaitFor("barley", process=mill, timeout=0.01)

    def test_a_sack_is_added(self, launch_service: Any, proc_info: Any, proc_output: Any) -> None:
        sack = python("sack", "print('open')\ninput()")
        with launch_process(launch_service, sack, proc_info, proc_output) as process:
            self.assertTrue(process.wait_for_output(lambda text: "open" in text, timeout=60))
            self.assertTrue(process.running)
        self.assertTrue(process.wait_for_shutdown(timeout=60))
        self.assertFalse(process.running)


@launch_testing.post_shutdown_test()
class TestAfterwards(unittest.TestCase):
    def test_all_ended_well(self, proc_info: Any, mill: ExecuteProcess, probe: Any) -> None:
        for process in (mill, probe):
            launch_testing.asserts.assertExitCodes(proc_info, process=process)

    def test_the_mill_worked_in_order(self, proc_output: Any, mill: Any, grain: str) -> None:
        with launch_testing.asserts.assertSequentialStdout(proc_output, mill) as told:
            told.assertInStdout("stones turn")
            told.assertInStdout(grain)
            with self.assertRaises(AssertionError):
                told.assertInStdout("stones turn")
