from __future__ import annotations

import dataclasses
import sys
from dataclasses import dataclass, field
from types import ModuleType, SimpleNamespace
from typing import Annotated, Any, ClassVar

import pytest

from zbot.interfaces import (
    get_message,
    get_service,
    has_sequences,
    spec_of,
    type_hash,
    type_name,
)
from zbot.interfaces.errors import InterfaceKindError, NotAMessageTypeError
from zbot.interfaces.python_class import (
    check_for_type_support,
    check_is_valid_msg_type,
    check_is_valid_srv_type,
)
from zbot.interfaces.spec import FieldType, MessageSpec, ServiceSpec

from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from std_srvs.srv import Trigger


@dataclass
class Place:
    x: float
    y: float = 1.5


@dataclass
class Everything:
    flag: bool
    count: int
    ratio: float
    label: str
    raw: bytes
    place: Place
    text: String
    flags: list[bool]
    numbers: list[float]
    places: list[Place]
    small: Annotated[int, "uint8"] = 7
    matrix: Annotated[list[float], "float32[9]"] = field(default_factory=lambda: [0.0] * 9)
    short: Annotated[str, "string<=5"] = "abc"
    noted: Annotated[int, ("not", "a type")] = 0
    shared: ClassVar[int] = 5


@dataclass
class Itself:
    others: list[Itself]


class Plain:
    pass


def test_a_dataclass_is_a_message() -> None:
    spec = spec_of(Everything)
    assert isinstance(spec, MessageSpec)
    assert spec.name.endswith("/msg/Everything")
    package = spec.package
    assert {f.name: f.type for f in spec.fields} == {
        "flag": FieldType("bool"),
        "count": FieldType("int64"),
        "ratio": FieldType("float64"),
        "label": FieldType("string"),
        "raw": FieldType("uint8", "sequence"),
        "place": FieldType(f"{package}/msg/Place"),
        "text": FieldType("std_msgs/msg/String"),
        "flags": FieldType("bool", "sequence"),
        "numbers": FieldType("float64", "sequence"),
        "places": FieldType(f"{package}/msg/Place", "sequence"),
        "small": FieldType("uint8"),
        "matrix": FieldType("float32", "array", 9),
        "short": FieldType("string", string_bound=5),
        "noted": FieldType("int64"),
    }
    assert {f.name: f.default for f in spec.fields if f.default is not None} == {
        "small": 7,
        "short": "abc",
        "noted": 0,
    }


def test_a_dataclass_is_found_by_its_name() -> None:
    assert spec_of(Everything) is spec_of(Everything)
    assert get_message(type_name(Place)) is Place  # type: ignore[comparison-overlap]
    assert type_hash(Place).startswith("RIHS01_")
    assert type_hash(Everything) != type_hash(Place)


@pytest.mark.parametrize(
    ("module", "main", "package"),
    [
        ("my_robot.parts.sensor", None, "my_robot"),
        ("MyRobot", None, "myrobot"),
        (
            "__main__",
            SimpleNamespace(__file__="/home/a/my-talker.py", __spec__=None),
            "my_talker",
        ),
        ("__main__", SimpleNamespace(__file__="/home/ana/2nd.py", __spec__=None), "script_2nd"),
        ("__main__", SimpleNamespace(__spec__=SimpleNamespace(name="my_robot.node")), "my_robot"),
        ("__main__", SimpleNamespace(__spec__=None), "main"),
    ],
)
def test_the_package_is_the_module_or_the_script(
    module: str, main: Any, package: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    if main is not None:
        monkeypatch.setitem(sys.modules, "__main__", main)
    cls = dataclasses.make_dataclass("Reading", [("value", float)])
    cls.__module__ = module
    monkeypatch.setitem(sys.modules, module, main or ModuleType(module))
    assert type_name(cls) == f"{package}/msg/Reading"


@pytest.mark.parametrize(
    ("fields", "reason"),
    [
        ([("x", dict)], "field 'x' is dict; it can be bool, int"),
        ([("x", int | None)], "field 'x' is"),
        ([("x", list)], "field 'x' is list"),
        ([("x", list[list[int]])], "field 'x' is list"),
        ([("x", tuple[int, int])], "field 'x' is tuple"),
        ([("x", Plain)], "field 'x' is Plain"),
        ([("x", "Undefined")], "define the classes of its fields at the top level of a module"),
        ([("x", Annotated[int, "int23"])], "there is no type 'int23'"),
        ([("fieldName", int)], "e.g. 'field_name'"),
        ([("_private", int)], "field name '_private' is not valid"),
    ],
)
def test_an_impossible_field_is_refused(fields: Any, reason: str) -> None:
    with pytest.raises(NotAMessageTypeError) as caught:
        spec_of(dataclasses.make_dataclass("Reading", fields))
    assert reason in str(caught.value)
    assert "Reading cannot be used" in str(caught.value)


def test_a_dataclass_that_contains_itself_is_refused() -> None:
    with pytest.raises(NotAMessageTypeError, match="contains itself"):
        spec_of(Itself)


def test_a_class_name_that_ros_rejects() -> None:
    with pytest.raises(NotAMessageTypeError, match=r"e\.g\. 'MyReading'"):
        spec_of(dataclasses.make_dataclass("my_reading", [("x", int)]))


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        (int, "it is not a message, service or action"),
        (Plain, "use an interface class or a dataclass"),
        (String(), "it is an instance; pass its class, String"),
        ("std_msgs/msg/String", "write String without quotes"),
        (sys, "it is a module; write one of its classes"),
        (5, "it is not a class"),
    ],
)
def test_a_class_that_is_not_a_message_class_is_rejected(given: Any, reason: str) -> None:
    with pytest.raises(NotAMessageTypeError, match=reason):
        spec_of(given)


def test_derived_classes_have_the_type_of_their_base() -> None:
    class Named(String):
        pass

    assert type_name(Named) == type_name(String) == "std_msgs/msg/String"
    assert isinstance(spec_of(get_service("std_srvs/srv/SetBool")), ServiceSpec)


def slot(kind: str, **facts: Any) -> Any:
    """Return the type of a field as in ROS 2's generated classes: its class name identifies it."""
    return type(kind, (SimpleNamespace,), {})(**facts)


def foreign(name: str, module: str, fields: dict[str, Any], **attributes: Any) -> type[Any]:
    def get_fields_and_field_types() -> dict[str, str]:
        return dict.fromkeys(fields, "")

    return type(
        name,
        (),
        {
            "__module__": module,
            "SLOT_TYPES": tuple(fields.values()),
            "get_fields_and_field_types": staticmethod(get_fields_and_field_types),
            **attributes,
        },
    )


def test_specs_of_ros2_message_classes(monkeypatch: pytest.MonkeyPatch) -> None:
    inner = foreign("Inner", "real_msgs.msg._inner", {"x": slot("BasicType", typename="double")})
    module = ModuleType("real_msgs.msg")
    module.__dict__["Inner"] = inner
    monkeypatch.setitem(sys.modules, "real_msgs", ModuleType("real_msgs"))
    monkeypatch.setitem(sys.modules, "real_msgs.msg", module)
    nested = slot("NamespacedType", namespaces=["real_msgs", "msg"], name="Inner")
    outer = foreign(
        "Outer",
        "real_msgs.msg._outer",
        {
            "flag": slot("BasicType", typename="boolean"),
            "raw": slot("UnboundedSequence", value_type=slot("BasicType", typename="octet")),
            "name": slot("UnboundedString"),
            "names": slot(
                "BoundedSequence", value_type=slot("BoundedString", maximum_size=4), maximum_size=3
            ),
            "covariance": slot("Array", value_type=slot("BasicType", typename="float"), size=9),
            "inner": nested,
        },
        NAME__DEFAULT="robot",
        COVARIANCE__DEFAULT=[0.0] * 9,
    )
    spec = spec_of(outer)
    assert isinstance(spec, MessageSpec)
    assert spec.name == "real_msgs/msg/Outer"
    assert [f.type for f in spec.fields] == [
        FieldType("bool"),
        FieldType("byte", "sequence"),
        FieldType("string"),
        FieldType("string", "sequence", 3, 4),
        FieldType("float32", "array", 9),
        FieldType("real_msgs/msg/Inner"),
    ]
    assert [f.default for f in spec.fields[2:5]] == ["robot", None, (0.0,) * 9]
    # A decoded Outer contains the real Inner.
    assert get_message("real_msgs/msg/Inner") is inner


def test_specs_of_ros2_service_classes() -> None:
    parts = {
        part: foreign(
            f"Ask_{part}", "real_srvs.srv._ask", {"x": slot("BasicType", typename="int32")}
        )
        for part in ("Request", "Response")
    }
    service = type("Ask", (), {"__module__": "real_srvs.srv._ask", **parts})
    spec = spec_of(service)
    assert isinstance(spec, ServiceSpec)
    assert spec.name == "real_srvs/srv/Ask"
    assert spec.request.name == "real_srvs/srv/Ask_Request"


def test_a_class_with_invalid_slots_is_refused() -> None:
    with pytest.raises(NotAMessageTypeError, match=r"not of the form package\.msg\._name"):
        spec_of(foreign("Odd", "odd", {}))
    with pytest.raises(NotAMessageTypeError, match="no SLOT_TYPES"):
        spec_of(foreign("Odd", "odd.msg._odd", {"x": 1}, SLOT_TYPES=()))


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("std_msgs/msg/String", False),
        ("geometry_msgs/msg/PoseWithCovarianceStamped", False),  # always 36 numbers
        ("sensor_msgs/msg/Image", True),
        ("tf2_msgs/msg/TFMessage", True),
        ("stereo_msgs/msg/DisparityImage", True),  # it contains an Image
        ("std_srvs/srv/SetBool_Request", False),
    ],
)
def test_messages_with_unbounded_fields_are_recognized(name: str, expected: bool) -> None:
    assert has_sequences(name) is expected


def test_interfaces_of_every_kind_pass() -> None:
    for interface in (String, Trigger, Fibonacci, Trigger.Request):
        check_for_type_support(interface)
    check_is_valid_msg_type(String)
    check_is_valid_srv_type(Trigger)


@pytest.mark.parametrize("caught", [TypeError, AttributeError])
def test_other_classes_are_refused_as_programs_expect(caught: type[Exception]) -> None:
    with pytest.raises(caught, match="int cannot be used as an interface type"):
        check_for_type_support(int)


@pytest.mark.parametrize("caught", [NotAMessageTypeError, RuntimeError])
def test_other_kinds_are_refused(caught: type[Exception]) -> None:
    with pytest.raises(caught, match=r"Trigger .* it is a service, not a message"):
        check_is_valid_msg_type(Trigger)
    with pytest.raises(caught, match=r"String .* it is a message, not a service"):
        check_is_valid_srv_type(String)
    with pytest.raises(InterfaceKindError):
        check_is_valid_srv_type(Fibonacci)
