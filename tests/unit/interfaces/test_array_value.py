from __future__ import annotations

import copy
import sys
from array import array
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from zbot.interfaces import array_value, field_check
from zbot.interfaces.array_value import (
    DTYPES,
    elements_text,
    fixed_array,
    fixed_default,
    same_elements,
)
from zbot.interfaces.classes import make_message
from zbot.interfaces.parser import parse_message


@pytest.fixture
def without_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(array_value, "numpy", lambda: None)
    for module in (array_value, field_check):
        monkeypatch.setattr(module, "is_ndarray", lambda _value: False)


@pytest.mark.parametrize("typecode", DTYPES)
def test_typecodes_and_dtypes_have_the_same_size(typecode: str) -> None:
    assert np.dtype(DTYPES[typecode]).itemsize == array(typecode).itemsize
    assert fixed_array(typecode, [1, 2]).dtype == DTYPES[typecode]


def test_a_fixed_array_can_be_written_to() -> None:
    values = fixed_array("d", [1.0])
    values[0] = 2.0
    assert values.tolist() == [2.0]


def test_defaults_are_new_objects() -> None:
    make = fixed_default("i", 2, (1, 2))
    make()[0] = 9
    assert make().tolist() == [1, 2]
    assert fixed_default("f", 3)().tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("left", "right", "is_same"),
    [
        (np.zeros(2), np.zeros(2), True),
        (np.zeros(2), np.ones(2), False),
        (np.zeros(2), array("d", [0.0, 0.0]), True),
        (np.zeros(2), np.zeros(3), False),
        (array("d", [1.0]), array("d", [1.0]), True),
        (array("d", [1.0]), array("d", [2.0]), False),
    ],
)
def test_same_elements(left: object, right: object, *, is_same: bool) -> None:
    assert same_elements(left, right) is is_same


def test_sequences_are_shown_without_their_type() -> None:
    assert elements_text(array("d", [1.0, 2.5])) == "[1.0, 2.5]"
    assert elements_text(array("B")) == "[]"


@pytest.mark.usefixtures("without_numpy")
def test_without_numpy_fixed_arrays_are_arrays() -> None:
    spec = parse_message("demo_msgs/msg/Demo", "float64[2] x\nuint8[2] y [1, 2]")
    cls = make_message(spec, {})
    message = cls(x=[1, 2])
    assert repr(message) == ("demo_msgs.msg.Demo(x=array('d', [1.0, 2.0]), y=array('B', [1, 2]))")
    assert copy.deepcopy(message) == message
    assert cls() != message
    with pytest.raises(ValueError, match="a list of 2 values"):
        cls(x=[1])


def test_messages_are_made_while_another_thread_imports_numpy(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    fields = "uint8[] x\nstring[] y\nfloat64[2] z"
    cls = make_message(parse_message("demo_msgs/msg/Demo", fields), {})
    monkeypatch.setitem(sys.modules, "numpy", ModuleType("numpy"))  # it is empty at first
    message: Any = cls(x=(3, 4), y=("five",), z=(1, 2))
    assert message.x == array("B", [3, 4])
