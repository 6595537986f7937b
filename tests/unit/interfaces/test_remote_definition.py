from __future__ import annotations

import contextlib
import json
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from zbot.errors import InterfaceConflictError, InterfaceSyntaxError
from zbot.interfaces import get_spec, interface_names, register_description, type_description
from zbot.interfaces.description import hash_of
from zbot.interfaces.location import shipped_packages
from zbot.interfaces.remote_definition import specs_from

if TYPE_CHECKING:
    from zbot.interfaces.spec import InterfaceSpec

NAMES = [name for package in shipped_packages() for name in interface_names(package)]


def test_a_description_read_back_has_the_same_hash() -> None:
    for name in NAMES:
        specs = {spec.name: spec for spec in specs_from(type_description(name))}

        def find(each: str, specs: dict[str, InterfaceSpec] = specs) -> InterfaceSpec:
            return specs.get(each) or get_spec(each)

        assert hash_of(specs[name], find) == hash_of(get_spec(name), get_spec)


def test_a_type_from_elsewhere_can_be_used() -> None:
    text = json.dumps(type_description("geometry_msgs/msg/PoseStamped"))
    description = json.loads(text.replace("geometry_msgs", "far_msgs"))
    spec = register_description(description)
    assert spec is get_spec("far_msgs/msg/PoseStamped")
    assert "far_msgs/Pose pose" in spec.text
    assert get_spec("far_msgs/msg/Quaternion")


def test_a_type_that_differs_here_is_refused() -> None:
    description = json.loads(json.dumps(type_description("std_msgs/msg/Header")))
    register_description(description)
    description["type_description"]["fields"].reverse()
    with pytest.raises(InterfaceConflictError, match="std_msgs/msg/Header is defined differently"):
        register_description(description)


def described(**changes: Any) -> dict[str, Any]:
    kind = {"type_id": 6, "capacity": 0, "string_capacity": 0, "nested_type_name": "", **changes}
    fields = [{"name": "x", "type": kind}]
    main = {"type_name": "far_msgs/msg/Odd", "fields": fields}
    return {"type_description": main, "referenced_type_descriptions": []}


@pytest.mark.parametrize(
    ("description", "reason"),
    [
        ({}, "KeyError"),
        ({"type_description": 5}, "TypeError"),
        (described(type_id=99999), "no type number"),
        (described(type_id=0), "no type number 0"),
        (described(type_id=13), "no type number 13"),
        (described(type_id=-3), "no type number -3"),
        (described(type_id=54, capacity=2**30), "from 1 to"),
        (described(type_id=21, string_capacity=0), "from 1 to"),
        (described(type_id=1, nested_type_name="../../etc"), "not of the form"),
        (described(type_id=1, nested_type_name="float64"), "not of the form"),
        (described(type_id="x"), "ValueError"),
    ],
)
def test_what_is_no_description_is_refused(description: dict[str, Any], reason: str) -> None:
    with pytest.raises(InterfaceSyntaxError) as caught:
        specs_from(description)
    assert reason in str(caught.value)


_JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=5,
)


@given(_JSON, st.sampled_from(["type_id", "capacity", "string_capacity", "nested_type_name"]))
def test_anything_in_a_field_is_read_or_refused(value: Any, key: str) -> None:
    with contextlib.suppress(InterfaceSyntaxError):
        specs_from(described(**{key: value}))


@given(_JSON, st.sampled_from(["type_description", "referenced_type_descriptions"]))
def test_anything_in_a_description_is_read_or_refused(value: Any, key: str) -> None:
    with contextlib.suppress(InterfaceSyntaxError):
        specs_from({**described(), key: value})
