from __future__ import annotations

import contextlib
import json
import time
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.conftest import allowed
from zbot.errors import WrongValueError
from zbot.interfaces import (
    MessageSpec,
    get_spec,
    interface_names,
    register_description,
    type_description,
    type_hash,
)
from zbot.interfaces.definition_limits import check_limits
from zbot.interfaces.description import hash_of
from zbot.interfaces.errors import DefinitionLimitError, InterfaceSyntaxError, UnknownInterfaceError
from zbot.interfaces.location import shipped_packages
from zbot.interfaces.parser import parse
from zbot.interfaces.registry import register_spec
from zbot.interfaces.remote_definition import hash_among, specs_from, specs_from_sources

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
    with pytest.raises(WrongValueError, match="std_msgs/msg/Header is defined differently"):
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
def test_an_invalid_description_is_rejected(description: dict[str, Any], reason: str) -> None:
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


# -- from texts ----------------------------------------------------------------------------------


def test_texts_keep_comments_constants_and_defaults() -> None:
    texts = {
        "far_msgs/msg/Part": "string name 'arm' # which\n",
        "far_msgs/msg/Whole": "# All of it.\nint32 MOST=3\nPart[<=3] parts\n",
    }
    part, whole = specs_from_sources("far_msgs/msg/Whole", texts)
    assert isinstance(part, MessageSpec)
    assert isinstance(whole, MessageSpec)
    assert part.fields[0].default == "arm"
    assert whole.constants[0].value == 3
    assert whole.text == texts["far_msgs/msg/Whole"]


def test_texts_have_the_hashes_of_the_types_that_they_define() -> None:
    for name in NAMES:
        described = type_description(name)
        inside = [part["type_name"] for part in described["referenced_type_descriptions"]]
        texts = {
            type_name: get_spec(type_name).text
            for type_name in (name, *inside)
            if "_" not in type_name.rpartition("/")[2]  # parts of a service or an action have none
        }
        assert hash_among(name, specs_from_sources(name, texts)) == type_hash(name)


def test_parts_of_definitions_from_texts_have_hashes() -> None:
    text = get_spec("example_interfaces/action/Fibonacci").text
    specs = specs_from_sources("far_msgs/action/Count", {"far_msgs/action/Count": text})
    assert hash_among("far_msgs/action/Count_SendGoal", specs).startswith("RIHS01_")


@pytest.mark.parametrize(
    ("name", "texts"),
    [
        ("far_msgs/msg/Odd", {}),
        ("far_msgs/msg/Odd", {"far_msgs/msg/Other": "int32 x\n"}),
        ("far_msgs/msg/Odd", {"far_msgs/msg/Odd": "int33 x\n"}),
        ("far_msgs/msg/Odd", {"far_msgs/msg/Odd": "int32 x\n", "../msg/Up": "int32 x\n"}),
        ("far_msgs/msg/Odd", {"far_msgs/msg/Odd": "int32 x\n", "far": "int32 x\n"}),
    ],
)
def test_texts_without_the_definition_are_rejected(name: str, texts: dict[str, str]) -> None:
    with pytest.raises(InterfaceSyntaxError):
        specs_from_sources(name, texts)


def test_a_hash_needs_all_nested_definitions() -> None:
    specs = specs_from_sources("std_msgs/msg/Half", {"std_msgs/msg/Half": "Unheard part\n"})
    with pytest.raises(UnknownInterfaceError):
        hash_among("std_msgs/msg/Half", specs)


# -- limits --------------------------------------------------------------------------------------


def doubling(levels: int) -> dict[str, str]:
    texts = {f"evil_msgs/msg/A{i}": f"A{i + 1} a\nA{i + 1} b\n" for i in range(levels)}
    return texts | {f"evil_msgs/msg/A{levels}": "int32 x\n", "evil_msgs/msg/Bomb": "A0 a\n"}


def chain(levels: int) -> dict[str, str]:
    texts = {f"evil_msgs/msg/A{i}": f"A{i + 1}[] a\n" for i in range(levels)}
    return texts | {f"evil_msgs/msg/A{levels}": "int32 x\n", "evil_msgs/msg/Bomb": "A0 a\n"}


def bomb(text: str, **parts: str) -> dict[str, str]:
    others = {f"evil_msgs/msg/{name}": part for name, part in parts.items()}
    return others | {"evil_msgs/msg/Bomb": text}


@pytest.mark.parametrize(
    ("texts", "reason"),
    [
        (doubling(30), "an empty evil_msgs/msg/A14 would contain more than 100000 messages"),
        (bomb("A[4096] a\n", A="B[4096] b\n", B="int32 x\n"), "more than 16777216 bytes"),
        (bomb("float64[16777216] a\n"), "more than 16777216 bytes"),
        (bomb("bool[16777216] a\n"), "more than 16777216 bytes"),
        (bomb("".join(f"float64[1000000] a{i}\n" for i in range(9))), "16777216 bytes"),
        (bomb("Big[] a\n", Big="float64[16777216] a\n"), "16777216 bytes"),
        (bomb("geometry_msgs/PoseWithCovariance[1000000] a\n"), "16777216 bytes"),
        (chain(100), "it has more than 60 levels"),
        (chain(2000), "it has more than 1000 parts"),
        (bomb("Bomb[] a\n"), "evil_msgs/msg/Bomb contains itself"),
        (bomb("A a\n", A="Bomb b\n"), "contains itself"),
        (bomb("".join(f"bool a{i}\n" for i in range(10_001))), "it has more than 10000 fields"),
        (bomb("#" * 1_000_001), "its text has more than 1000000 characters"),
    ],
)
def test_a_definition_that_would_fill_the_memory_is_refused(
    texts: dict[str, str], reason: str
) -> None:
    begin = time.process_time()
    with pytest.raises(DefinitionLimitError) as caught:
        check_limits(specs_from_sources("evil_msgs/msg/Bomb", texts))
    assert time.process_time() - begin < allowed(2)
    assert str(caught.value).startswith("evil_msgs/msg/Bomb: zbot does not use this definition")
    assert str(caught.value).endswith(reason)
    assert caught.value.type_name == "evil_msgs/msg/Bomb"


def test_a_description_that_would_fill_the_memory_is_refused() -> None:
    with pytest.raises(DefinitionLimitError, match="far_msgs/msg/Odd"):
        register_description(described(type_id=59, capacity=2**24))


def test_the_interfaces_of_this_machine_are_within_the_limits() -> None:
    for name in NAMES:
        check_limits([get_spec(name)])


def test_a_thousand_definitions_are_registered_quickly() -> None:
    specs = [parse(f"many_msgs/msg/A{i}", "int32 x\n") for i in range(1000)]
    begin = time.process_time()
    for spec in specs:
        register_spec(spec)
    assert time.process_time() - begin < allowed(3)
