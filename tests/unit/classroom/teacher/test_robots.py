from __future__ import annotations

import pytest

from zbot.classroom.errors import ClassroomError
from zbot.classroom.teacher.robots import Robots, driver_in


def test_one_student_at_a_time_drives_a_robot() -> None:
    robots = Robots()
    assert robots.note("arm") is None
    robots.give("arm", 17)
    robots.give("arm", 18)
    assert (robots.drivers, robots.note("arm")) == ({"arm": 18}, 18)
    robots.give("arm", None)
    assert robots.note("arm") is None


@pytest.mark.parametrize(
    ("connected", "advice"),
    [([], "connect one with"), (["arm"], "the robots are arm"), (["robots"], "did you mean")],
)
def test_a_robot_without_a_bridge_cannot_be_given(connected: list[str], advice: str) -> None:
    robots = Robots()
    for name in connected:
        robots.note(name)
    with pytest.raises(ClassroomError, match=advice):
        robots.give("robot", 17)


def test_a_robot_whose_bridge_is_gone_is_taken_from_its_driver(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    robots = Robots()
    robots.note("arm")
    robots.give("arm", 17)
    monkeypatch.setattr("zbot.classroom.teacher.robots._LOST_S", -1.0)
    assert robots.connected() == []
    robots.give("arm", None)
    assert robots.drivers == {}


@pytest.mark.parametrize("document", [{}, {"drivers": 5}, {"drivers": {"arm": "17"}}])
def test_a_damaged_document_has_no_driver(document: dict[str, object]) -> None:
    assert driver_in(document, "arm") is None
    assert driver_in({"drivers": {"arm": 17}}, "arm") == 17
