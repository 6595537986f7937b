from __future__ import annotations

from typing import Any

import pytest

from zbot.classroom.hub.address import Address
from zbot.classroom.student.lobby import membership_from

GIVEN: dict[str, Any] = {"class": "4b", "number": 17, "name": "Ana", "claim": "a1", "hub_id": "f0"}
ADDRESS = Address("10.0.0.1", 7447)


def test_a_class_gives_a_membership() -> None:
    joined = membership_from(ADDRESS, {**GIVEN, "user": "student17", "secret": "ab"})
    assert (joined.number, joined.user, joined.secret) == (17, "student17", "ab")


@pytest.mark.parametrize(
    "changes",
    [
        {"number": 0},
        {"number": 233},
        {"number": 10**30},
        {"number": "17"},
        {"number": None},
        {"user": "a:b"},
        {"secret": "x\ny:z"},
        {"secret": 5},
        {"claim": "\ud800"},
        {"hub_id": "é"},
        {"hub_id": "a" * 1000},
    ],
)
def test_an_invalid_membership_is_refused(changes: dict[str, Any]) -> None:
    with pytest.raises((ValueError, TypeError)):
        membership_from(ADDRESS, {**GIVEN, **changes})
