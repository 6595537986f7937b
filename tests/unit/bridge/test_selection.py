from __future__ import annotations

import pytest

from zbot.bridge.errors import PatternError
from zbot.bridge.routes import RateLimit
from zbot.bridge.selection import Direction, Pattern, Selection, patterns, read_rate

IN, OUT = Direction.IN, Direction.OUT


def test_patterns_select_names_and_directions() -> None:
    selection = Selection(topics=patterns(["/camera/*:in", "cmd_vel:out", "/tf"]))
    assert selection.takes_topic("/camera/left/image", IN)
    assert not selection.takes_topic("/camera/left/image", OUT)
    assert selection.takes_topic("/cmd_vel", OUT)
    assert selection.takes_topic("/tf", IN)
    assert selection.takes_topic("/tf", OUT)
    assert not selection.takes_topic("/scan", IN)
    assert not selection.takes_service("/lamp", "std_srvs/srv/SetBool", IN)


def test_excluded_names_are_left_out() -> None:
    selection = Selection(excluded=patterns(["/debug/*"]))
    assert not selection.takes_topic("/debug/state", IN)
    assert not selection.takes_service("/debug/reset", "std_srvs/srv/Empty", IN)
    assert selection.takes_topic("/scan", IN)


def test_a_star_does_not_mean_what_every_node_has_but_its_name_does() -> None:
    assert not Selection(topics=patterns(["*"])).takes_topic("/rosout", IN)
    assert Selection(topics=patterns(["/rosout"])).takes_topic("/rosout", IN)


@pytest.mark.parametrize("text", ["", ":in", "/scan:up", "/scan:"])
def test_a_wrong_pattern_is_refused(text: str) -> None:
    with pytest.raises(PatternError):
        Pattern.parse(text)


def test_rates_are_read() -> None:
    assert read_rate("/camera/*:in=5") == (Pattern("/camera/*", IN), 5.0)
    selection = Selection(rates=(read_rate("/image=0.5"),))
    assert selection.rate("/image", OUT) == 0.5
    assert selection.rate("/other", OUT) == 0


@pytest.mark.parametrize("text", ["", "/image", "/image=", "=5", "/image=0", "/image=-1", "/a=nan"])
def test_a_wrong_rate_is_refused(text: str) -> None:
    with pytest.raises(PatternError):
        read_rate(text)


@pytest.mark.parametrize(("source_hz", "passed"), [(30, 50), (7, 50), (3, 30), (1000, 50)])
def test_a_limit_lets_the_right_number_of_messages_pass(source_hz: int, passed: int) -> None:
    limit = RateLimit(5.0)
    times = [number / source_hz for number in range(10 * source_hz)]
    assert sum(map(limit.admits, times)) == pytest.approx(passed, abs=1)


def test_a_pause_is_not_made_up_for() -> None:
    limit = RateLimit(10.0)
    assert limit.admits(0.0)
    assert limit.admits(100.0)
    assert sum(limit.admits(100.0 + number / 1000) for number in range(100)) <= 1
