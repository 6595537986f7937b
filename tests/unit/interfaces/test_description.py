from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from zbot.interfaces import description, get_interface, get_spec, type_description, type_hash
from zbot.interfaces.parser import parse_message

if TYPE_CHECKING:
    from zbot.interfaces.spec import InterfaceSpec

# Hashes of ROS 2's own generator. Those of example_interfaces and std_srvs, which have no wheels,
# are from independent implementations that agree.
HASHES: dict[str, str] = json.loads(
    (Path(__file__).parent / "data" / "rihs01.json").read_text(encoding="utf-8")
)


# Types of ROS 2's DDS middleware, which zbot does not have.
DDS_TYPES = {
    "Gid": (
        "char[16] data",
        "RIHS01_ab6f21cfbb0a6dbb837161e1110c2051a2850ed9f9c53944d7115d9bcebedf71",
    ),
    "NodeEntitiesInfo": (
        (
            "string<=256 node_namespace\nstring<=256 node_name\n"
            "Gid[] reader_gid_seq\nGid[] writer_gid_seq"
        ),
        "RIHS01_8ffef65ee2d088c63b1e8fcd31e800ba9fc8dbe0ee15ca60d1676de5218087a7",
    ),
    "ParticipantEntitiesInfo": (
        "Gid gid\nNodeEntitiesInfo[] node_entities_info_seq",
        "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e",
    ),
}


def nothing_inside(name: str) -> InterfaceSpec:
    raise AssertionError(name)


@pytest.mark.parametrize("name", HASHES)
def test_hash_equals_that_of_ros(name: str) -> None:
    assert type_hash(name) == HASHES[name]


@pytest.mark.parametrize("short", DDS_TYPES)
def test_hash_of_nested_and_bounded_fields_equals_that_of_ros(short: str) -> None:
    specs = {
        name: parse_message(name, text)
        for name, (text, _) in (
            (f"rmw_dds_common/msg/{name_in_dds}", DDS_TYPES[name_in_dds])
            for name_in_dds in DDS_TYPES
        )
    }
    spec = specs[f"rmw_dds_common/msg/{short}"]
    assert description.hash_of(spec, specs.__getitem__) == DDS_TYPES[short][1]


def test_a_class_has_the_hash_of_its_name() -> None:
    for name in (
        "std_msgs/msg/String",
        "std_srvs/srv/SetBool",
        "example_interfaces/action/Fibonacci",
    ):
        assert type_hash(get_interface(name)) == HASHES[name]


def type_of(line: str) -> dict[str, Any]:
    spec = parse_message("demo_msgs/msg/Demo", line)
    described: dict[str, Any] = description.type_description(spec, get_spec)["type_description"]
    result: dict[str, Any] = described["fields"][0]["type"]
    return result


@pytest.mark.parametrize(
    ("line", "type_id", "capacity", "string_capacity", "nested"),
    [
        ("float64 x", 11, 0, 0, ""),
        ("char x", 3, 0, 0, ""),
        ("byte x", 16, 0, 0, ""),
        ("wstring x", 18, 0, 0, ""),
        ("string<=5 x", 21, 0, 5, ""),
        ("wstring<=5 x", 22, 0, 5, ""),
        ("int8[3] x", 50, 3, 0, ""),
        ("int8[<=3] x", 98, 3, 0, ""),
        ("int8[] x", 146, 0, 0, ""),
        ("string<=5[<=2] x", 117, 2, 5, ""),
        ("geometry_msgs/Point[] x", 145, 0, 0, "geometry_msgs/msg/Point"),
    ],
)
def test_type_ids(
    line: str, type_id: int, capacity: int, string_capacity: int, nested: str
) -> None:
    assert type_of(line) == {
        "type_id": type_id,
        "capacity": capacity,
        "string_capacity": string_capacity,
        "nested_type_name": nested,
    }


def test_references_are_sorted_and_each_is_there_once() -> None:
    described = type_description("geometry_msgs/msg/TwistWithCovarianceStamped")
    names = [each["type_name"] for each in described["referenced_type_descriptions"]]
    assert names == [
        "builtin_interfaces/msg/Time",
        "geometry_msgs/msg/Twist",
        "geometry_msgs/msg/TwistWithCovariance",
        "geometry_msgs/msg/Vector3",
        "std_msgs/msg/Header",
    ]


def test_a_message_without_fields_has_the_member_of_its_c_structure() -> None:
    fields = type_description("std_msgs/msg/Empty")["type_description"]["fields"]
    assert [field["name"] for field in fields] == ["structure_needs_at_least_one_member"]


@pytest.mark.parametrize(
    ("one", "other", "is_same"),
    [
        ("int32 a\nint32 b", "int32 b\nint32 a", False),
        ("int32 a", "int64 a", False),
        ("int32 a", "int32 a 5  # with a default", True),
        ("int32 a", "int32 A=1\nint32 a", True),
        ("char a", "uint8 a", True),
    ],
)
def test_some_differences_change_the_hash(one: str, other: str, *, is_same: bool) -> None:
    hashes = [
        description.hash_of(parse_message("demo_msgs/msg/Demo", text), nothing_inside)
        for text in (one, other)
    ]
    assert (hashes[0] == hashes[1]) is is_same
