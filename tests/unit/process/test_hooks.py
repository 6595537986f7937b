"""Tests of the exception hooks of `zbot run`."""

from __future__ import annotations

import sys
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from zbot.process import hooks, signals
from zbot.threads.foreign_call import is_deferring_signals

if TYPE_CHECKING:
    import pytest


def test_a_signal_waits_while_a_lost_one_is_sent_again(monkeypatch: pytest.MonkeyPatch) -> None:
    waits: list[bool] = []
    monkeypatch.setattr(
        signals, "send_again", lambda _: waits.append(is_deferring_signals(sys._getframe()))
    )
    monkeypatch.setattr(sys, "unraisablehook", None)
    monkeypatch.setattr(sys, "excepthook", sys.excepthook)
    monkeypatch.setattr("threading.excepthook", None)
    hooks.install()
    lost: Any = SimpleNamespace(exc_value=signals.Interrupted(2))
    sys.unraisablehook(lost)
    assert waits == [True]
