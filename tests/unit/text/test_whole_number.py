from __future__ import annotations

import pytest

from zbot.text.whole_number import whole_number


@pytest.mark.parametrize(("text", "number"), [("0", 0), ("007", 7), ("9" * 18, 10**18 - 1)])
def test_digits_are_a_number(text: str, number: int) -> None:
    assert whole_number(text) == number


@pytest.mark.parametrize("text", ["", "-1", "+1", " 1", "1_0", "²", "٣", "0x1", "1.0", "9" * 5000])
def test_everything_else_is_no_number(text: str) -> None:
    assert whole_number(text) is None


def test_a_caller_may_limit_the_digits() -> None:
    assert whole_number("999", 3) == 999
    assert whole_number("0999", 3) is None
    assert whole_number(str(2**63), 19) == 2**63
