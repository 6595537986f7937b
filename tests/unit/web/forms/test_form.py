"""Tests of forms of message types: inputs, entries and their errors."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot  # noqa: F401 - makes the message packages importable
from zbot.interfaces import FieldType
from zbot.interfaces.message_reader import FieldMisfitError
from zbot.web.forms import form as form_module
from zbot.web.forms.form import Entry, Form, Group, Input, InputKind
from zbot.web.forms.form_value import read, show

from builtin_interfaces.msg import Duration, Time
from example_interfaces.action import Fibonacci
from geometry_msgs.msg import Point32, Polygon, PoseStamped, PoseWithCovariance, Twist
from sensor_msgs.msg import JointState, LaserScan
from std_msgs.msg import Bool, Byte, ByteMultiArray, Empty, Header, Int8, String, UInt8MultiArray
from turtlesim.srv import SetPen, Spawn

if TYPE_CHECKING:
    from collections.abc import Callable

_NO_FIELD = "'Point32' object has no attribute 'w'; its fields are x, y, z"
_POINT_WANTED = (
    "Value '5' is expected to be a dictionary but is a int; "
    "write points[0]: {x: ..., y: ..., z: ...}"
)
_FLOAT, _FLOAT32 = "a float within float32's range", "is a float32: write"
_OCTET, _R = "an int from 0 to 255", "r is a uint8: write r: 2"
_X, _POINT = "linear.x is a float64: write x: 1.5", "write a point, not a comma"
_ELEMENT, _ELEMENT_HINT = f"ranges[1] must be {_FLOAT}", f"ranges[1] {_FLOAT32} ranges[1]: 1.5"
_36_WANTED = (
    "covariance must be a list of 36 values, of which each is a float, not [1, 2]; "
    "covariance is float64[36]: write covariance: [...]"
)
NOW_NS = 1_700_000_000_123_456_789


def now_ns() -> int:
    return NOW_NS


def test_every_field_has_an_input_in_the_order_of_the_definition() -> None:
    form = Form(Spawn.Request)
    assert [(input_.path, input_.kind, input_.default) for input_ in form.inputs] == [
        ("x", InputKind.NUMBER, "0.0"),
        ("y", InputKind.NUMBER, "0.0"),
        ("theta", InputKind.NUMBER, "0.0"),
        ("name", InputKind.TEXT, ""),
    ]


def test_fields_that_are_messages_are_groups() -> None:
    linear, angular = Form(Twist).members
    assert isinstance(linear, Group)
    assert (linear.path, linear.type_name) == ("linear", "geometry_msgs/msg/Vector3")
    assert [member.path for member in linear.members] == ["linear.x", "linear.y", "linear.z"]
    assert [member.name for member in linear.members] == ["x", "y", "z"]
    assert angular.name == "angular"


def test_integer_inputs_have_bounds() -> None:
    bounds = {input_.path: input_.bounds for input_ in Form(SetPen.Request).inputs}
    assert bounds == dict.fromkeys(["r", "g", "b", "width", "off"], (0, 255))
    assert Form(Int8).inputs[0].bounds == (-128, 127)
    assert Form(Twist).inputs[0].bounds is None


def test_entries_become_the_message() -> None:
    entries: dict[str, Entry] = {"x": "2", "y": 3.5, "theta": "-.5", "name": "eve"}
    assert Form(Spawn.Request).message(entries) == Spawn.Request(
        x=2.0, y=3.5, theta=-0.5, name="eve"
    )
    moved = Form(Twist).message({"linear.x": "2.0", "angular.z": "1.8"})
    assert (moved.linear.x, moved.linear.y, moved.angular.z) == (2.0, 0.0, 1.8)


def test_missing_entries_keep_defaults() -> None:
    assert Form(Twist).message({}) == Twist()
    assert Form(PoseWithCovariance).message({}).pose.orientation.w == 1.0
    assert Form(Empty).message({}) == Empty()
    assert Form(Fibonacci.Goal).message({"order": 5}) == Fibonacci.Goal(order=5)


@pytest.mark.parametrize(
    ("message_type", "entry", "value"),
    [
        (Bool, True, True),
        (Bool, "no", False),
        (Byte, "7", b"\x07"),
        (Int8, 5.0, 5),
        (Int8, "0x1f", 31),
        (String, " as it is ", " as it is "),
        (String, None, ""),
        (UInt8MultiArray, "[1, 2]", [1, 2]),
        (UInt8MultiArray, "1, 2", [1, 2]),
        (ByteMultiArray, "1, 2", [b"\x01", b"\x02"]),
    ],
)
def test_an_entry_is_converted_to_the_type_of_its_field(
    message_type: type, entry: Entry, value: object
) -> None:
    made = Form(message_type).message({"data": entry}).data
    assert (list(made) if isinstance(value, list) else made) == value


def test_lists_of_texts_and_of_messages() -> None:
    made = Form(JointState).message({"name": "[no, '2', a b]", "position": "1, .nan"})
    assert made.name == ["no", "2", "a b"]
    assert made.position[0] == 1.0
    points = Form(Polygon).message({"points": "[{x: 1, y: 2.5}, {z: 3}]"}).points
    assert [(point.x, point.y, point.z) for point in points] == [(1.0, 2.5, 0.0), (0.0, 0.0, 3.0)]


@pytest.mark.parametrize(
    ("message_type", "path", "entry", "sentence"),
    [
        (Twist, "linear.x", "fast", f"linear.x must be a float, not 'fast'; {_X}"),
        (Twist, "linear.x", "2,5", f"linear.x must be a float, not '2,5'; {_POINT}: x: 2.5"),
        (Twist, "linear.x", "", f"linear.x must be a float, not ''; {_X}"),
        (
            UInt8MultiArray,
            "data",
            f"[{'1, ' * 4000}1]",
            "data has 12,003 characters, and at most 10,000 fit; use a program instead",
        ),
        (SetPen.Request, "r", "256", f"r must be {_OCTET}, not 256; {_R}"),
        (SetPen.Request, "r", "2.5", f"r must be {_OCTET}, not '2.5'; {_R}"),
        (Spawn.Request, "x", "1e40", f"x must be {_FLOAT}, not 1e+40; x {_FLOAT32} x: 1.5"),
        (Bool, "data", "maybe", "data must be a bool, not 'maybe'; data is a bool: write"),
        (PoseWithCovariance, "covariance", "[1, 2]", _36_WANTED),
        (LaserScan, "ranges", "[1, x]", f"{_ELEMENT}, not 'x'; {_ELEMENT_HINT}"),
        (LaserScan, "ranges", "[1, [2]]", f"{_ELEMENT}, not ['2']; {_ELEMENT_HINT}"),
        (LaserScan, "ranges", "[", f"ranges must be a list, of which each is {_FLOAT}, not '['"),
        (Polygon, "points", "[{w: 1}]", _NO_FIELD),
        (Polygon, "points", "[5]", _POINT_WANTED),
        (Header, "stamp", "soon", "stamp must be seconds, not 'soon'"),
        (Header, "stamp", "1e10", "stamp is a builtin_interfaces/msg/Time: 1e10 s does not fit"),
        (Header, "stamp", "inf", "stamp must be seconds, not 'inf'"),
        (Header, "stamp", "11e999999", "stamp must be seconds, not '11e999999'"),
    ],
)  # fmt: skip
def test_a_wrong_entry_raises_a_sentence(
    message_type: type, path: str, entry: str, sentence: str
) -> None:
    form = Form(message_type)
    assert form.problems({path: entry})[path].startswith(sentence)
    with pytest.raises(FieldMisfitError) as caught:
        form.message({path: entry})
    assert caught.value.path.startswith(path)
    assert caught.value.sentence.startswith(sentence)


def test_a_stamp_is_now_by_default() -> None:
    form = Form(PoseStamped)
    stamp = form.message({}, now_ns).header.stamp
    assert (stamp.sec, stamp.nanosec) == divmod(NOW_NS, 10**9)
    assert form.yaml({}) == "{header: {stamp: now}}"
    assert form.message({"header.stamp": "12.5"}).header.stamp == Time(sec=12, nanosec=500_000_000)
    assert form.yaml({"header.stamp": "12.5"}) == "{header: {stamp: {sec: 12, nanosec: 500000000}}}"


def counted_reads(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return a list to which the path of each entry that is read is added."""
    reads: list[str] = []

    def counting(kind: FieldType, entry: Entry, path: str, now_ns: Callable[[], int]) -> object:
        reads.append(path)
        return read(kind, entry, path, now_ns)

    monkeypatch.setattr(form_module, "read", counting)
    return reads


def test_only_a_changed_entry_is_read_and_only_once(monkeypatch: pytest.MonkeyPatch) -> None:
    reads, form = counted_reads(monkeypatch), Form(Twist)
    speed = next(input_ for input_ in form.inputs if input_.path == "linear.x")
    for entry, problems in (("2", []), ("x", ["linear.x"]), ("3", [])):
        entries = {"linear.x": entry, "angular.z": "1.5"}
        assert (form.problem(speed, entry) is None) == (not problems)
        assert list(form.problems(entries)) == problems
        if not problems:
            assert form.yaml(entries).startswith(f"{{linear: {{x: {entry}.0}}")
            assert form.message(entries).linear.x == float(entry)
    assert sorted(reads) == ["angular.z", *["linear.x"] * 3]


def test_a_repeated_message_is_made_once_with_new_stamps(monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter([10**9, 2 * 10**9, 3 * 10**9])
    make = Form(PoseStamped).maker({"pose.position.x": "2"}, lambda: next(times))
    reads = counted_reads(monkeypatch)
    first = make()
    assert (first.header.stamp.sec, first.pose.position.x) == (2, 2.0)
    assert make().header.stamp.sec == 3
    assert set(reads) == {"header.stamp"}


def test_lists_of_times_have_the_present_time_too() -> None:
    kind = FieldType("builtin_interfaces/msg/Time", "sequence")
    times = Input("times", kind, InputKind.LIST, "[]")
    assert times.has_now("[now]")
    assert not times.has_now("[1]")
    assert not Input("name", FieldType("string"), InputKind.TEXT, "").has_now("now")


def test_times_are_exact_to_the_nanosecond() -> None:
    form = Form(Header)
    shown = form.entries(Header(stamp=Time(sec=1_700_000_000, nanosec=1)))
    assert shown["stamp"] == "1700000000.000000001"
    assert form.message(shown).stamp == Time(sec=1_700_000_000, nanosec=1)


@pytest.mark.parametrize(
    "message",
    [
        Spawn.Request(x=1.5, name="yes"),
        JointState(header=Header(stamp=Time(sec=3)), name=["a: b", "no"], position=[1.0, -2.5e-7]),
        PoseWithCovariance(covariance=[float(n) for n in range(36)]),
        ByteMultiArray(data=[b"\x00", b"\xff"]),
        Polygon(),
    ],
)
def test_a_message_can_be_shown_and_read_back(message: object) -> None:
    form = Form(type(message))
    assert repr(form.message(form.entries(message))) == repr(message)


def test_a_long_array_of_zeros_is_left_empty() -> None:
    covariance = next(input_ for input_ in Form(PoseWithCovariance).inputs if "cov" in input_.path)
    assert covariance.default == ""
    assert covariance.max_length == 36


@pytest.mark.parametrize(
    ("kind", "value", "text"),
    [
        (FieldType("float64", "sequence"), [0.5] * 1000, "[0.5, 0.5, "),
        (FieldType("float64", "sequence"), [0.5] * 1_000_000, "[1,000,000 elements]"),
        (FieldType("byte", "sequence"), [b"\x01"] * 1001, "[1,001 elements]"),
        (FieldType("int8", "array", 2000), [1] * 2000, "[2,000 elements]"),
        (FieldType("int8", "array", 2000), [0] * 2000, ""),
        (FieldType("geometry_msgs/msg/Point32", "array", 2000), [Point32()] * 2000, ""),
        (FieldType("geometry_msgs/msg/Point32", "array", 2), [Point32()] * 2, "[{x: 0.0, "),
    ],
)
def test_of_a_long_list_only_the_number_of_elements_is_shown(
    kind: FieldType, value: object, text: str
) -> None:
    shown = show(kind, value)
    assert shown.startswith(text) if text else not shown


def test_yaml_has_only_changed_fields() -> None:
    assert Form(Twist).yaml({"linear.x": "2", "angular.z": 1.8}) == (
        "{linear: {x: 2.0}, angular: {z: 1.8}}"
    )
    assert Form(Twist).yaml({}) == "{}"
    assert Form(Spawn.Request).yaml({"name": "yes"}) == "{name: 'yes'}"
    assert Form(LaserScan).yaml({"header.stamp": "0", "ranges": "1, 2"}) == "{ranges: [1.0, 2.0]}"


def test_durations_may_be_negative() -> None:
    kind = FieldType("builtin_interfaces/msg/Duration")
    half = Duration(sec=-1, nanosec=500_000_000)
    assert show(kind, half) == "-0.5"
    assert read(kind, "-0.5", "rest", now_ns) == half
