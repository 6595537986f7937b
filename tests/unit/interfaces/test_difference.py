from __future__ import annotations

import pytest

from zbot.interfaces.difference import difference
from zbot.interfaces.parser import parse

HERE = "float64 celsius\nint32 number\n"


@pytest.mark.parametrize(
    ("there", "expected"),
    [
        (HERE, ""),
        (f"# another comment\n{HERE}", ""),
        ("float32 celsius\nint32 number", "`celsius` is float64 here and float32 there"),
        ("float64[] celsius\nint32 number", "`celsius` is float64 here and float64[] there"),
        ("float64 celsius", "`number` is only here"),
        (f"{HERE}string unit", "`unit` is only there"),
        ("int32 number\nfloat64 celsius", "the fields have another order"),
    ],
)
def test_the_difference_of_two_definitions_names_the_field(there: str, expected: str) -> None:
    found = difference(
        [parse("lab_msgs/msg/Reading", HERE)], [parse("lab_msgs/msg/Reading", there)]
    )
    assert found == (f"in lab_msgs/msg/Reading, {expected}" if expected else "")


def test_parts_and_nested_types_are_compared() -> None:
    here = [parse("lab_msgs/srv/Ask", "int32 a\n---\nint32 b"), parse("lab_msgs/msg/In", "int8 x")]
    there = [parse("lab_msgs/srv/Ask", "int32 a\n---\nint64 b"), parse("lab_msgs/msg/In", "int8 y")]
    assert difference(here, there) == (
        "in lab_msgs/msg/In, `x` is only here; in lab_msgs/msg/In, `y` is only there; "
        "in lab_msgs/srv/Ask_Response, `b` is int32 here and int64 there"
    )


def test_a_long_difference_is_cut() -> None:
    texts = ["".join(f"int8 {letter}{number}\n" for number in range(9)) for letter in "ab"]
    here, there = ([parse("lab_msgs/msg/Long", text)] for text in texts)
    assert difference(here, there).endswith("`a3` is only here, and 14 more")
