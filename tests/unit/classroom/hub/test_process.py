from __future__ import annotations

from zbot.classroom.hub.process import _Signals


def test_a_hub_that_was_just_opened_is_not_reopened_for_an_older_request() -> None:
    signals = _Signals()
    assert signals.begin()
    signals.reopen()
    signals.wait()
    signals.reopen()  # a laptop asks again while the hub is being closed
    assert signals.begin()
    assert not signals._happened.is_set()


def test_a_signal_while_the_hub_is_closed_ends_the_process() -> None:
    signals = _Signals()
    signals.end(15, None)
    assert not signals.begin()
