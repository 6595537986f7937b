from __future__ import annotations

import pytest

from zbot.observer.rate_meter import RateMeter

MS = 10**6


def test_rate_without_messages_is_zero() -> None:
    meter = RateMeter()
    assert meter.rates(0) == (0.0, 0.0)
    meter.add(0, 10)
    assert meter.rates(1) == (0.0, 0.0)


@pytest.mark.parametrize("rate_hz", [0.5, 1, 10, 50, 1000])
def test_steady_arrivals_give_their_rate_and_bytes(rate_hz: float) -> None:
    meter, now = RateMeter(), 0
    for number in range(int(8 * rate_hz) + 1):
        now = int(number / rate_hz * 1e9)
        meter.add(now, 20)
    assert meter.rates(now) == pytest.approx((rate_hz, rate_hz * 20), rel=0.01)


def test_rate_falls_in_a_silence_and_becomes_zero() -> None:
    meter = RateMeter()
    for number in range(50):
        meter.add(number * 100 * MS, 1)
    last = 49 * 100 * MS
    assert meter.rates(last + 100 * MS)[0] == pytest.approx(10, rel=0.05)
    assert 4 < meter.rates(last + 2000 * MS)[0] < 8
    assert meter.rates(last + 6000 * MS) == (0.0, 0.0)


def test_rate_follows_a_change_within_its_window() -> None:
    meter, now = RateMeter(), 0
    for period in (100 * MS, 10 * MS):
        for _ in range(6 * 10**9 // period):
            now += period
            meter.add(now, 1)
    assert meter.rates(now)[0] == pytest.approx(100, rel=0.02)
