"""Tests of the sentences for broken set-ups of transforms: frames, cause, and what to type."""

from __future__ import annotations

import pytest

from tests.unit.tf2.diagnosis.robot import SECOND, START_NS, Robot
from zbot.tf2.diagnosis import Cause
from zbot.tf2.diagnosis.problem import duration_text

STATIC = "zbot run tf2_ros static_transform_publisher --frame-id {} --child-frame-id {}"


@pytest.fixture
def robot() -> Robot:
    return Robot()


def test_a_whole_tree_has_no_problem(robot: Robot) -> None:
    robot.fix("base_link", "laser")
    robot.drive(("map", "odom"), ("odom", "base_link"))
    assert robot.problems() == []
    assert robot.knows("map", "laser")
    assert robot.knows("laser", "map", age_s=0.5)
    assert robot.knows("map", "map", age_s=0.5)


def test_no_publisher_is_named(robot: Robot) -> None:
    found = robot.why("map", "laser")
    assert found.cause is Cause.NO_PUBLISHER
    assert found.text == "no transform from laser to map: nobody publishes on /tf and /tf_static"
    assert "zbot topic info -v /tf" in found.advice
    assert robot.problem().text == "nobody publishes on /tf and /tf_static"


def test_a_silent_publisher_is_named(robot: Robot) -> None:
    robot.diagnosis.set_endpoints({"/tf": ["/driver"]}, {})
    found = robot.why("map", "laser")
    assert found.cause is Cause.SILENT_PUBLISHER
    assert found.text.endswith(
        "nothing comes on /tf and /tf_static; the publisher /driver is silent"
    )
    assert "look at the output of /driver" in found.advice
    problem = robot.problem()
    assert problem.text == "/driver can publish on /tf, but nothing has come"
    assert not problem.is_warning


def test_a_frame_that_nobody_publishes_is_named(robot: Robot) -> None:
    robot.drive(("odom", "base_link"))
    found = robot.why("odom", "laser")
    assert found.cause is Cause.UNKNOWN_FRAME
    assert found.text == "no transform from laser to odom: nobody publishes the frame `laser`"
    assert STATIC.format("base_link", "laser") in found.advice


def test_two_trees_name_the_missing_link(robot: Robot) -> None:
    robot.drive(("earth", "map"), ("odom", "base_link"))
    robot.fix("base_link", "laser")
    found = robot.why("map", "laser")
    assert found.cause is Cause.TWO_TREES
    assert found.text == (
        "no transform from laser to map: `earth` and `odom` are two trees; "
        "nobody publishes map -> odom"
    )
    assert found.frames == ("map", "odom")
    assert "AMCL or SLAM" in found.advice
    assert STATIC.format("map", "odom") in found.advice
    assert robot.problem().text == "`earth` and `odom` are two trees; nobody publishes map -> odom"


def test_robots_with_separate_trees_lack_a_map(robot: Robot) -> None:
    robot.drive(("robot1/odom", "robot1/base_link"), ("robot2/odom", "robot2/base_link"))
    found = robot.why("robot1/base_link", "robot2/base_link")
    assert found.text.endswith("are two trees; nobody publishes map -> robot2/odom")


def test_a_bag_without_a_clock_is_a_warning(robot: Robot) -> None:
    for _ in range(20):
        robot.publish("odom", "base_link", node="/player", stamp_ns=robot.now_ns - 600 * SECOND)
        robot.wait(0.1)
    found = robot.problem()
    assert found.cause is Cause.MIXED_TIME
    assert found.is_warning
    assert "zbot bag play BAG --clock" in found.advice


def test_a_link_that_ignores_the_simulated_clock_is_a_warning(robot: Robot) -> None:
    robot.publishers["/clock"] = ["/sim"]
    robot.drive(("odom", "base_link"))
    found = robot.problem()
    assert (found.cause, found.is_warning) == (Cause.MIXED_TIME, True)
    assert "zbot param set /driver use_sim_time true" in found.advice


def test_the_number_of_links_is_limited(robot: Robot) -> None:
    for number in range(10_050):
        robot.fix("map", f"stone_{number}")
    assert len(robot.diagnosis.links()) < 100


def test_a_silent_publisher_is_named_with_two_trees(robot: Robot) -> None:
    robot.publishers["/tf"] = ["/slam"]
    robot.drive(("earth", "map"), ("odom", "base_link"))
    assert (
        "look at the output of /slam: it has sent no transform yet"
        in robot.why("map", "odom").advice
    )


def test_a_loop_names_its_frames_and_nodes(robot: Robot) -> None:
    robot.drive(("a", "b"), ("b", "c"))
    robot.drive(("c", "a"), node="/wrong")
    robot.fix("map", "odom")
    found = robot.why("map", "b")
    assert found.cause is Cause.LOOP
    assert found.text == "no transform from b to map: a -> b -> c -> a is a loop"
    assert "zbot node info /driver; zbot node info /wrong" in found.advice
    assert robot.problems()[0].text == "a -> b -> c -> a is a loop"


def test_two_parents_name_both_publishers(robot: Robot) -> None:
    robot.fix("base_footprint", "base_link", node="/robot_state_publisher")
    robot.drive(("odom", "base_link"))
    missing = robot.why("odom", "base_footprint")
    unreliable = robot.why("odom", "base_link")
    assert missing.text.startswith("no transform from base_footprint to odom: ")
    assert unreliable.text.startswith("the transform from base_link to odom is not reliable: ")
    assert (missing.is_warning, unreliable.is_warning) == (False, True)
    for found in (missing, unreliable, robot.problems()[0]):
        assert found.cause is Cause.TWO_PARENTS
        assert (
            "`base_link` has 2 parents, `odom` (/driver on /tf) and "
            "`base_footprint` (/robot_state_publisher on /tf_static); a frame can have only one"
        ) in found.text
        assert "zbot node info /robot_state_publisher" in found.advice


def test_a_frame_that_gets_another_parent_has_one_parent(robot: Robot) -> None:
    robot.drive(("table", "cup"))
    robot.drive(("hand", "cup"))
    assert robot.knows("hand", "cup")
    assert Cause.TWO_PARENTS not in {problem.cause for problem in robot.problems()}


def test_a_static_transform_of_an_ended_node_gives_way_to_a_new_one(robot: Robot) -> None:
    robot.fix("table", "cup", node="/static_transform_publisher_1")
    robot.fix("cup", "straw", node="/static_transform_publisher_1", x=1.0)
    robot.end("/static_transform_publisher_1")
    robot.wait(1)
    robot.fix("hand", "cup", node="/static_transform_publisher_2")
    robot.fix("cup", "straw", node="/static_transform_publisher_2", x=2.0)
    assert robot.problems() == []
    assert robot.knows("hand", "straw")


def test_a_stale_transform_is_named_with_its_age(robot: Robot) -> None:
    robot.fix("base_link", "laser")
    robot.drive(("odom", "base_link"))
    robot.wait(3.1)
    found = robot.why("odom", "laser", age_s=0.0)
    assert found.cause is Cause.STALE
    assert found.text == (
        "no transform from laser to odom: `odom -> base_link` (/driver on /tf) was last heard "
        "3.2 s ago"
    )
    assert "look at the output of /driver" in found.advice
    assert "zbot topic hz /tf" in found.advice
    robot.end("/driver")
    assert robot.problem().text.endswith("was last heard 3.2 s ago: its node has ended")
    assert robot.problem().advice == "start /driver again"


def test_a_clock_ahead_is_named_with_its_error(robot: Robot) -> None:
    robot.drive(("odom", "base_link"), clock_error_ns=4 * 10**8)
    found = robot.problem()
    assert found.cause is Cause.CLOCK_AHEAD
    assert found.text == (
        "the publisher's clock is 0.4 s ahead: `odom -> base_link` (/driver on /tf) is stamped in "
        "the future"
    )
    assert "sudo timedatectl set-ntp true" in found.advice
    assert "zbot doctor --tf" in found.advice


def test_a_scan_from_a_clock_ahead_is_named(robot: Robot) -> None:
    robot.drive(("odom", "base_link"))
    found = robot.why("odom", "base_link", age_s=-0.4)
    assert found.cause is Cause.CLOCK_AHEAD
    assert found.text == (
        "no transform from base_link to odom: the newest scan is stamped in the future: "
        "the publisher's clock is 0.4 s ahead"
    )
    assert "zbot topic delay /scan" in found.advice


def test_stamps_ahead_of_a_right_clock_are_a_warning(robot: Robot) -> None:
    for _ in range(20):
        robot.publish("map", "odom", node="/amcl", stamp_ns=robot.now_ns + SECOND)
        robot.wait(0.1)
    found = robot.problem()
    assert found.cause is Cause.STAMPED_AHEAD
    assert found.is_warning
    assert "`map -> odom` (/amcl on /tf) is stamped 1.0 s ahead" in found.text
    assert "transform_tolerance" in found.advice


def test_simulated_time_and_time_of_day_are_named(robot: Robot) -> None:
    for tenth in range(20):
        robot.publish("odom", "base_link", node="/sim", stamp_ns=tenth * 10**8, x=tenth)
        robot.drive(("map", "odom"), seconds=0.1, node="/slam")
    found = robot.why("map", "base_link")
    assert found.cause is Cause.MIXED_TIME
    assert found.text == (
        "no transform from base_link to map: `odom -> base_link` (/sim on /tf) has simulated or "
        "recorded time, and `map -> odom` (/slam on /tf) has the time of day"
    )
    assert "zbot param set /slam use_sim_time true" in found.advice
    assert "--ros-args -p use_sim_time:=true" in found.advice
    assert robot.problem().cause is Cause.MIXED_TIME


def test_a_scan_with_another_kind_of_time_is_named(robot: Robot) -> None:
    for tenth in range(20):
        robot.publish("odom", "base_link", node="/sim", stamp_ns=tenth * 10**8, x=tenth)
        robot.wait(0.1)
    found = robot.why("odom", "base_link", age_s=0.1)
    assert found.cause is Cause.MIXED_TIME
    assert (
        "the newest scan has the time of day, and the transform odom -> base_link (/sim on /tf) "
        "has simulated or recorded time"
    ) in found.text


def test_a_frame_with_a_wrong_letter_is_named(robot: Robot) -> None:
    robot.fix("base_link", "laser")
    robot.drive(("odom", "base_link"))
    found = robot.why("odom", "lazer")
    assert found.cause is Cause.WRONG_NAME
    assert found.text == (
        "no transform from lazer to odom: nobody publishes the frame `lazer`; did you mean 'laser'?"
    )
    assert "write 'laser' in place of 'lazer'" in found.advice


def test_a_wrong_letter_between_two_trees_is_named(robot: Robot) -> None:
    robot.fix("base_lnk", "laser")
    robot.drive(("odom", "base_link"))
    found = robot.why("odom", "laser")
    assert found.cause is Cause.WRONG_NAME
    assert found.text.endswith(
        "are two trees; the names `base_lnk` and `base_link` are almost the same"
    )
    assert "write 'base_link' in place of 'base_lnk'" in found.advice
    assert robot.problem().cause is Cause.WRONG_NAME


def test_a_leading_slash_is_named(robot: Robot) -> None:
    robot.fix("/base_link", "laser")
    robot.drive(("odom", "base_link"))
    found = robot.why("odom", "/laser")
    assert found.cause is Cause.LEADING_SLASH
    assert found.text == (
        "no transform from /laser to odom: the name '/laser' begins with a slash, which tf2 does "
        "not accept"
    )
    assert "write 'laser' in place of '/laser'" in found.advice
    assert robot.knows("odom", "laser")
    problem = robot.problem()
    assert problem.cause is Cause.LEADING_SLASH
    assert problem.is_warning
    assert "`base_link -> laser` (/mount on /tf_static)" in problem.text


def test_a_static_transform_on_tf_is_named(robot: Robot) -> None:
    robot.publish("base_link", "laser", node="/mount")
    robot.drive(("odom", "base_link"), seconds=3)
    found = robot.why("odom", "laser", age_s=0.1)
    assert found.cause is Cause.STATIC_ON_TF
    assert "`base_link -> laser` (/mount on /tf) came only once" in found.text
    assert "StaticTransformBroadcaster" in found.advice
    assert STATIC.format("base_link", "laser") in found.advice
    assert robot.problem().cause is Cause.STATIC_ON_TF


def test_a_node_that_ended_after_one_transform_has_ended(robot: Robot) -> None:
    robot.publish("odom", "base_link")
    robot.wait(3)
    robot.end("/driver")
    assert robot.problem().text.endswith("its node has ended")


def test_a_stamp_that_never_changes_is_named(robot: Robot) -> None:
    for _ in range(20):
        robot.publish("base_link", "laser", node="/mount", stamp_ns=START_NS)
        robot.drive(("odom", "base_link"), seconds=0.1)
    found = robot.why("odom", "laser", age_s=0.1)
    assert found.cause is Cause.STATIC_ON_TF
    assert "came again and again with the same stamp" in found.text


def test_a_robot_at_rest_is_not_static(robot: Robot) -> None:
    for _ in range(20):
        robot.publish("odom", "base_link")
        robot.wait(0.1)
    assert robot.problems() == []


def test_transforms_of_a_namespace_are_named(robot: Robot) -> None:
    robot.fix("base_link", "laser", topic="/robot1/tf_static")
    robot.drive(("odom", "base_link"), topic="/robot1/tf")
    found = robot.why("odom", "laser")
    assert found.cause is Cause.NAMESPACE
    assert found.text == (
        "no transform from laser to odom: `odom` and `laser` are on /robot1/tf, "
        "and the program hears /tf"
    )
    assert "--ros-args -r /tf:=/robot1/tf -r /tf_static:=/robot1/tf_static" in found.advice
    assert "zbot run topic_tools relay /robot1/tf /tf" in found.advice
    assert "where nobody listens" in robot.problem().text
    robot.diagnosis.topic = "/robot1/tf"
    assert robot.knows("odom", "laser")


def test_a_namespace_is_named_if_only_one_frame_is_there(robot: Robot) -> None:
    robot.drive(("odom", "base_link"), topic="/robot1/tf")
    found = robot.why("map", "base_link")
    assert found.cause is Cause.NAMESPACE
    assert "nothing comes on /tf and /tf_static, but transforms come on /robot1/tf" in found.text


def test_a_namespace_with_a_listener_has_no_problem(robot: Robot) -> None:
    robot.listeners["/robot1/tf"] = ["/nav"]
    robot.drive(("odom", "base_link"), topic="/robot1/tf")
    assert robot.problems() == []


def test_an_extrapolation_into_the_future_is_named(robot: Robot) -> None:
    robot.drive(("odom", "base_link"))
    found = robot.why("odom", "base_link", age_s=0.02)
    assert found.cause is Cause.FUTURE
    assert found.text == (
        "no transform from base_link to odom: the newest scan is 80 ms newer than the newest "
        "transform odom -> base_link"
    )
    assert "it comes 10 times a second" in found.advice
    assert "timeout=Duration(seconds=1.0)" in found.advice


def test_a_scan_that_is_too_old_is_named(robot: Robot) -> None:
    robot.drive(("odom", "base_link"), seconds=1.1)
    found = robot.why("odom", "base_link", age_s=3.3)
    assert found.cause is Cause.PAST
    assert found.text == (
        "no transform from base_link to odom: the newest scan is 3.2 s older than the newest "
        "transform odom -> base_link; only the last 1.0 s are known"
    )
    assert "zbot topic delay /scan" in found.advice


def test_a_late_transform_is_named(robot: Robot) -> None:
    robot.drive(("odom", "base_link"), clock_error_ns=-2 * SECOND)
    found = robot.why("odom", "base_link", age_s=0.1)
    assert found.cause is Cause.CLOCK_BEHIND
    assert "arrives with stamps that are 2.0 s old: the publisher's clock is behind" in found.text


def test_two_publishers_of_one_transform_are_named(robot: Robot) -> None:
    for _ in range(10):
        robot.drive(("odom", "base_link"), seconds=0.1, node="/driver")
        robot.drive(("odom", "base_link"), seconds=0.1, node="/ekf")
    found = robot.problem()
    assert found.cause is Cause.SEVERAL_PUBLISHERS
    assert found.text == "`odom -> base_link` comes from 2 nodes: /driver and /ekf"
    assert "zbot node info /driver; zbot node info /ekf" in found.advice


def test_a_static_transform_that_moves_is_a_warning(robot: Robot) -> None:
    for x in range(6):
        robot.fix("base_link", "arm", x=x)
    found = robot.problem()
    assert found.cause is Cause.MOVING_ON_TF_STATIC
    assert found.is_warning
    assert "/tf" in found.advice


def test_an_empty_frame_id_is_named(robot: Robot) -> None:
    robot.drive(("odom", "base_link"))
    found = robot.why("odom", "")
    assert found.text == "no transform from '' to odom: the newest scan has no frame_id"
    assert "header.frame_id" in found.advice


@pytest.mark.parametrize(
    ("nanoseconds", "text"),
    [(8e7, "80 ms"), (3.2e9, "3.2 s"), (2.5e11, "4.2 minutes"), (3e14, "3 days")],
)
def test_ages_are_written_in_readable_units(nanoseconds: float, text: str) -> None:
    assert duration_text(nanoseconds) == text


def test_a_transform_that_is_static_and_moving_is_named(robot: Robot) -> None:
    robot.fix("odom", "base_link")
    robot.drive(("odom", "base_link"))
    found = robot.problem()
    assert found.cause is Cause.SEVERAL_PUBLISHERS
    assert found.text == (
        "`odom -> base_link` is static and moving: it comes from /driver on /tf and "
        "/mount on /tf_static"
    )


def test_stamps_that_do_not_meet_are_named(robot: Robot) -> None:
    for tenth in range(200):
        late_ns = robot.now_ns - 30 * SECOND
        robot.publish("map", "odom", node="/slam", stamp_ns=late_ns, x=tenth)
        robot.drive(("odom", "base_link"), seconds=0.1)
    found = robot.why("map", "base_link")
    assert found.cause is Cause.CLOCK_BEHIND
    assert found.text.endswith(
        "the stamps of map -> odom (/slam on /tf) are 30 s older than those of odom -> base_link"
    )


def test_a_lookup_before_the_first_stamp_of_a_clock_ahead_is_named(robot: Robot) -> None:
    robot.drive(("odom", "base_link"), seconds=0.3, clock_error_ns=2 * SECOND)
    found = robot.why("odom", "base_link", age_s=0.1)
    assert found.cause is Cause.CLOCK_AHEAD
    assert (
        "the publisher's clock is 2.0 s ahead: `odom -> base_link` (/driver on /tf)" in found.text
    )


def test_unknown_publishers_are_a_node(robot: Robot) -> None:
    robot.drive(("odom", "base_link"), node="")
    robot.wait(5)
    assert (
        "`odom -> base_link` (a node on /tf) was last heard"
        in robot.why("odom", "base_link", age_s=0).text
    )
