from __future__ import annotations

import time

import pytest

from tests.unit.tokens import STRING, endpoint_token
from zbot.classroom.errors import ClassValueError
from zbot.classroom.teacher.expectation import Expectation, parse_expectations
from zbot.graph.snapshot import Snapshot
from zbot.wire.tokens import EndpointToken, EntityKind, NodeToken


def endpoint(kind: EntityKind, name: str, type_name: str = STRING) -> EndpointToken:
    return endpoint_token(name, domain=17, kind=kind, type_name=type_name)


WORK = Snapshot(
    (
        NodeToken(domain=17, zid="a", nid=1, namespace="/", node="talker"),
        endpoint(EntityKind.PUBLISHER, "/student_id"),
        endpoint(EntityKind.SUBSCRIPTION, "/cmd_vel", "geometry_msgs/msg/Twist"),
        endpoint(EntityKind.SERVICE, "/add_two_ints", "example_interfaces/srv/AddTwoInts"),
    )
)


def problems(text: str, rate_hz: float = 1.0) -> list[str]:
    rates = {"/student_id": rate_hz}
    found = (expected.problem(WORK, rates) for expected in parse_expectations(text))  # pyright: ignore[reportArgumentType] - see Observed
    return [problem for problem in found if problem]


@pytest.mark.parametrize(
    "text",
    [
        "publishes std_msgs/String on /student_id at >= 1 Hz",
        "publishes std_msgs/msg/String on student_id",
        "Publishes std_msgs/String on /student_id at 1Hz",
        "subscribes geometry_msgs/Twist on /cmd_vel",
        "serves example_interfaces/AddTwoInts on /add_two_ints",
        "runs /talker",
        "runs talker and publishes std_msgs/String on /student_id",
        "publishes std_msgs/String on /student_id at < 1.5 Hz; runs talker",
        "publishes std_msgs/String on /student_id at = 1.0 Hz",
    ],
)
def test_a_correct_program_has_no_problem(text: str) -> None:
    assert problems(text) == []


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (
            "publishes std_msgs/String on /student_idd",
            "nobody publishes /student_idd; did you mean '/student_id'?",
        ),
        (
            "publishes std_msgs/String on /studentID",
            "nobody publishes /studentID; did you mean '/student_id'?",
        ),
        ("publishes std_msgs/String on /scan", "nobody publishes /scan"),
        (
            "publishes std_msgs/Int32 on /student_id",
            f"/student_id has type {STRING}, not std_msgs/msg/Int32",
        ),
        (
            "publishes std_msgs/String on /student_id at >= 2 Hz",
            "/student_id has 1.00 Hz, not >= 2 Hz",
        ),
        (
            "publishes std_msgs/String on /student_id at < 1 Hz",
            "/student_id has 1.00 Hz, not < 1 Hz",
        ),
        ("subscribes std_msgs/String on /student_id", "nobody subscribes to /student_id"),
        ("serves std_srvs/Trigger on /reset", "nobody serves /reset"),
        ("runs talkr", "/talkr does not run; did you mean '/talker'?"),
    ],
)
def test_a_mistake_is_named_with_the_probable_intention(text: str, problem: str) -> None:
    assert problems(text) == [problem]


def test_a_slightly_low_rate_is_accepted() -> None:
    assert problems("publishes std_msgs/String on /student_id at >= 1 Hz", rate_hz=0.98) == []
    assert problems("publishes std_msgs/String on /student_id at >= 1 Hz", rate_hz=0.9) != []


def test_a_publisher_without_messages_is_reported() -> None:
    text = "publishes std_msgs/String on /student_id at >= 1 Hz"
    assert problems(text, rate_hz=0) == ["/student_id has a publisher, but no message arrived"]


def test_expectations_are_parsed() -> None:
    assert parse_expectations("publishes std_msgs/String on student_id at >= 2.5 Hz") == [
        Expectation(EntityKind.PUBLISHER, "/student_id", STRING, ">=", 2.5)
    ]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("publish std_msgs/String on /x", "did you mean 'publishes'"),
        ("says hello", "must begin with publishes, subscribes, serves or runs"),
        ("publishes std_msgs/String", "`on /name` is missing"),
        ("publishes std_msgs/String on /x at fast", "must be like `at >= 1 Hz`"),
        ("publishes String on /x", "'String' is not a type"),
        ("publishes std_msgs/String on /1x", "must not start with a"),
        ("subscribes std_msgs/String on /x at >= 1 Hz", "only `publishes` can have a rate"),
        ("", "must begin with"),
    ],
)
def test_an_invalid_expectation_is_refused_with_the_reason(text: str, reason: str) -> None:
    with pytest.raises(ClassValueError, match=reason):
        parse_expectations(text)


def test_spaces_do_not_cost_time() -> None:
    begun_s = time.process_time()
    assert len(parse_expectations("runs /a" + " " * 60_000 + ";   runs /b  and  runs /c")) == 3
    with pytest.raises(ClassValueError) as caught:
        parse_expectations("publishes std_msgs/String on /a at" + "\n" * 60_000 + "/b" * 5000)
    assert len(str(caught.value)) < 500
    assert time.process_time() - begun_s < 0.5
