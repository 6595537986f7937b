from __future__ import annotations

import copy
import linecache
import math
import pickle
import re
import traceback
from array import array
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from zbot.errors import WrongTypeError
from zbot.interfaces import get_action, get_interface, get_message, get_service
from zbot.interfaces.classes import make_message, module_name
from zbot.interfaces.errors import FieldTypeError, UnknownFieldError
from zbot.interfaces.message import Message
from zbot.interfaces.parser import parse_message
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.codec import messagepack_codec_for

from example_interfaces.action import Fibonacci
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from collections.abc import Callable


def define(text: str) -> type[Any]:
    """Return a message class with the fields of a text; nested messages are zbot's."""
    spec = parse_message("demo_msgs/msg/Demo", text)
    return make_message(
        spec, {f.name: get_interface(f.type.base) for f in spec.fields if f.type.is_message}
    )


_TIME = "builtin_interfaces.msg.Time(sec=0, nanosec=0)"
_LAYOUT = "std_msgs.msg.MultiArrayLayout(dim=[], data_offset=0)"
_ZEROS = ", ".join(["0"] * 16)


@pytest.mark.parametrize(
    ("name", "fields", "expected"),
    [
        ("std_msgs/msg/String", {"data": "hi"}, "std_msgs.msg.String(data='hi')"),
        ("std_msgs/msg/Empty", {}, "std_msgs.msg.Empty()"),
        ("std_msgs/msg/Byte", {}, r"std_msgs.msg.Byte(data=b'\x00')"),
        ("std_msgs/msg/Char", {"data": 65}, "std_msgs.msg.Char(data=65)"),
        (
            "std_msgs/msg/Header",
            {"frame_id": "map"},
            f"std_msgs.msg.Header(stamp={_TIME}, frame_id='map')",
        ),
        (
            "std_msgs/msg/Float32MultiArray",
            {"data": [1, 2.5]},
            f"std_msgs.msg.Float32MultiArray(layout={_LAYOUT}, data=[1.0, 2.5])",
        ),
        (
            "std_msgs/msg/ByteMultiArray",
            {"data": [b"\x01"]},
            rf"std_msgs.msg.ByteMultiArray(layout={_LAYOUT}, data=[b'\x01'])",
        ),
        (
            "unique_identifier_msgs/msg/UUID",
            {},
            f"unique_identifier_msgs.msg.UUID(uuid=array([{_ZEROS}], dtype=uint8))",
        ),
        ("std_srvs/srv/SetBool_Request", {"data": True}, "std_srvs.srv.SetBool_Request(data=True)"),
    ],
)
def test_repr_is_that_of_ros(name: str, fields: dict[str, Any], expected: str) -> None:
    assert repr(get_interface(name)(**fields)) == expected


@pytest.mark.parametrize(
    ("line", "default"),
    [
        ("bool x", False),
        ("byte x", b"\x00"),
        ("char x", 0),
        ("int64 x", 0),
        ("float32 x", 0.0),
        ("string x", ""),
        ("wstring x", ""),
        ("int8[] x", array("b")),
        ("float64[<=3] x", array("d")),
        ("string[] x", []),
        ("bool[2] x", [False, False]),
        ("string[2] x", ["", ""]),
        ("byte[2] x", [b"\x00", b"\x00"]),
        ("int32 x -5", -5),
        ("float64 x inf", math.inf),
        ("float64 x -inf", -math.inf),
        ("string x 'it''s \\ \"q\"'".replace("''", "\\'"), 'it\'s \\ "q"'),
        ("byte x 7", b"\x07"),
        ("int16[] x [1, 2]", array("h", [1, 2])),
        ("float64[] x [1, inf]", array("d", [1.0, math.inf])),
        ("string[2] x ['a', 'b']", ["a", "b"]),
        ("bool[<=2] x [true]", [True]),
    ],
)
def test_default_values(line: str, default: object) -> None:
    value = define(line)().x
    assert value == default
    assert type(value) is type(default)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("float64 X=nan", math.nan),
        ("float64 X=-inf", -math.inf),
        ("float32 X=1e400", math.inf),
        ("float32 X=3.4028235e38", 3.4028234663852886e38),
        ("string X='a\\n\\'b'", "a\n'b"),
        ("int8 X=-0x80", -128),
        ("bool X=1", True),
        ("byte X=0xff", b"\xff"),
    ],
)
def test_a_constant_has_the_value_of_its_text(line: str, expected: object) -> None:
    value = define(line).X
    assert repr(value) == repr(expected)


def test_a_constant_may_have_a_name_that_the_source_of_the_class_needs() -> None:
    cls = define(
        "float64 INF=5\nfloat64 NAN=6\nint8 DEFAULT=7\nfloat64 a inf\nfloat64 b nan\nint8[] c\n"
    )
    assert (cls.INF, cls.NAN, cls.DEFAULT) == (5.0, 6.0, 7)
    assert repr(cls()) == "demo_msgs.msg.Demo(a=inf, b=nan, c=[])"
    assert repr(
        messagepack_codec_for(cls).decode(messagepack_codec_for(cls).encode(cls()))
    ) == repr(cls())
    assert repr(messagepack_codec_for(cls).decode(b"\x80")) == repr(cls())


@pytest.mark.parametrize(
    "line",
    [
        "int8[] x",
        "float64[2] x",
        "string[] x ['a']",
        "bool[2] x",
        "geometry_msgs/Point x",
        "geometry_msgs/Point[2] x",
    ],
)
def test_default_values_are_not_shared(line: str) -> None:
    cls = define(line)
    assert cls().x is not cls().x


def test_fixed_numeric_arrays_are_ndarrays_of_the_exact_type() -> None:
    message = define("float32[3] x\nuint64[2] y [1, 2]")()
    assert (message.x.dtype, message.x.shape) == (np.float32, (3,))
    assert (message.y.dtype, message.y.tolist()) == (np.uint64, [1, 2])
    message.x[0] = 1.5
    assert message.x.tolist() == [1.5, 0.0, 0.0]


def test_arrays_of_messages_hold_new_messages() -> None:
    first, second = define("geometry_msgs/Point[2] x")().x
    assert first == second
    assert first is not second


@pytest.fixture
def without_checks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_PYTHON_CHECK_FIELDS", "0")


_ALL_KINDS = "string text\nbool on\nint8 small\nstring[] words\nuint8[] raw\nfloat64[2] pair"


@pytest.mark.usefixtures("without_checks")
def test_fields_are_not_checked_if_the_environment_says_so() -> None:
    cls: Any = define(_ALL_KINDS)
    message = cls(text=False, small=1000, words=("a", 1), raw=[1], pair=[1, 2], txt="unknown")
    assert (message.text, message.small, message.words) == (False, 1000, ("a", 1))
    message.on = "yes"
    assert message.on == "yes"
    assert (message.raw, list(message.pair)) == (array("B", [1]), [1.0, 2.0])
    assert copy.deepcopy(message) == message
    with pytest.raises(CodecError, match="field 'text': expected a string, not bool False"):
        messagepack_codec_for(cls).encode(message)
    with pytest.raises(TypeError, match="give the fields of demo_msgs/msg/Demo by name"):
        cls("text")
    with pytest.raises(AssertionError):
        message.raw = ["a"]


@pytest.mark.usefixtures("without_checks")
def test_a_message_without_checks_can_ask_for_them() -> None:
    cls: Any = define(_ALL_KINDS)
    for wrong in ({"text": False}, {"small": 1000}, {"words": ["a", 1]}, {"txt": "unknown"}):
        with pytest.raises(AssertionError):
            cls(check_fields=True, **wrong)
    message = cls(text="a", check_fields=True)
    with pytest.raises(AssertionError):
        message.text = False
    assert define("int32 check_fields")(check_fields=3).check_fields == 3


def test_an_unknown_field_is_refused_with_the_near_one() -> None:
    with pytest.raises(UnknownFieldError, match="no field 'dta'; did you mean 'data'"):
        get_message("std_msgs/msg/String")(dta="x")
    with pytest.raises(UnknownFieldError, match="it has x, y, z"):
        get_message("geometry_msgs/msg/Point")(speed=1.0)
    with pytest.raises(TypeError, match="it has none"):
        get_message("std_msgs/msg/Empty")(data=1)


@pytest.mark.parametrize("check_fields", [True, False])
def test_fields_are_checked_for_any_value_of_check_fields(check_fields: bool) -> None:
    cls: Any = get_message("std_msgs/msg/String")
    message = cls(data="x", check_fields=check_fields)
    assert message == cls(data="x")
    for wrong in ({"data": 1}, {"dta": "x"}):
        with pytest.raises(AssertionError):  # ROS 2's own classes raise the same
            cls(check_fields=check_fields, **wrong)
    assert define("int32 check_fields")(check_fields=3).check_fields == 3


def test_values_without_names_are_refused() -> None:
    cls: Any = get_message("std_msgs/msg/String")
    with pytest.raises(WrongTypeError, match=r"give the fields .* by name: String\(data=\.\.\.\)"):
        cls("hi")


def test_a_field_that_does_not_exist_cannot_be_assigned() -> None:
    message: Any = get_message("std_msgs/msg/String")()
    with pytest.raises(AttributeError):
        message.dta = "x"


def test_equality_is_by_value() -> None:
    cls: Any = get_message("geometry_msgs/msg/PoseWithCovariance")
    one, other = cls(), cls()
    assert one == other
    other.covariance[7] = 1.0
    assert one != other
    other.covariance[7] = 0.0
    other.pose.position.x = 1
    assert one != other
    assert get_message("std_msgs/msg/Int32")() != get_message("std_msgs/msg/Int64")()


@pytest.mark.parametrize(
    ("name", "value", "advice"),
    [
        ("std_msgs/msg/String", "stop", "compare its field, e.g. message.data == 'stop'"),
        ("std_msgs/msg/Float32", 1.5, "compare its field, e.g. message.data == 1.5"),
        ("builtin_interfaces/msg/Time", 0, "message.sec == 0 (it has sec, nanosec)"),
    ],
)
def test_a_comparison_with_a_value_is_a_mistake(name: str, value: object, advice: str) -> None:
    message: Any = get_message(name)()
    text = f"a {name} is compared with {value!r}, and they always differ: "
    with pytest.warns(UserWarning, match=re.escape(text) + ".*" + re.escape(advice) + "$") as found:
        assert message != value
    assert found[0].filename == __file__
    assert message != None  # noqa: E711 - a program may ask whether it has a message
    assert get_message("std_msgs/msg/Empty")() != value


def test_messages_are_not_hashable() -> None:
    with pytest.raises(TypeError, match="unhashable"):
        hash(get_message("std_msgs/msg/String")())


@pytest.mark.parametrize(
    "duplicate",
    [copy.deepcopy, lambda message: pickle.loads(pickle.dumps(message))],
    ids=["deepcopy", "pickle"],
)
def test_a_duplicate_is_equal_and_independent(duplicate: Any) -> None:
    message: Any = get_message("sensor_msgs/msg/CameraInfo")(d=[1, 2], distortion_model="plumb_bob")
    twin = duplicate(message)
    assert twin == message
    assert type(twin) is type(message)
    twin.header.frame_id = "other"
    twin.d.append(3.0)
    twin.k[0] = 9.0
    assert message.header.frame_id == ""
    assert message.d.tolist() == [1.0, 2.0]
    assert message.k[0] == 0.0


def test_copy_shares_nested_messages() -> None:
    message: Any = get_message("geometry_msgs/msg/Twist")()
    twin = copy.copy(message)
    assert twin == message
    assert twin.linear is message.linear


def test_a_copy_of_a_derived_class_has_its_class() -> None:
    base: Any = get_message("std_msgs/msg/String")

    class Named(base):  # type: ignore[misc]
        pass

    message = Named(data="x")
    message.name = "n"
    twin = copy.deepcopy(message)
    assert (type(twin), twin.data, twin.name) == (Named, "x", "n")


@pytest.mark.parametrize(
    ("module", "expected"), [("__main__", "Named"), ("robot.texts.named", "robot.texts.Named")]
)
def test_a_derived_class_shows_its_own_name(module: str, expected: str) -> None:
    base = get_message("std_msgs/msg/String")
    assert repr(type("Named", (base,), {"__module__": module})()) == f"{expected}(data='')"


def test_field_types_are_those_that_ros_shows() -> None:
    cls = get_message("sensor_msgs/msg/JointState")
    types = cls.get_fields_and_field_types()
    assert types == {
        "header": "std_msgs/Header",
        "name": "sequence<string>",
        "position": "sequence<double>",
        "velocity": "sequence<double>",
        "effort": "sequence<double>",
    }
    types.clear()
    assert cls.get_fields_and_field_types()
    slots: Any = cls.__slots__
    assert slots == ["_header", "_name", "_position", "_velocity", "_effort"]


def test_constants_are_attributes_of_class_and_message() -> None:
    cls: Any = get_message("diagnostic_msgs/msg/DiagnosticStatus")
    assert (cls.OK, cls.WARN, cls().ERROR) == (b"\x00", b"\x01", b"\x02")
    assert define("string NAME=a b").NAME == "a b"
    assert define("int8 status -2").STATUS__DEFAULT == -2


@pytest.mark.parametrize("name", ["OK", "X__DEFAULT"])
def test_constants_cannot_be_assigned(name: str) -> None:
    cls: Any = define("byte OK=0\nint32[] x [1, 2]")
    for owner in (cls, cls(), type("Derived", (cls,), {"__slots__": ()})):
        before = getattr(owner, name)
        with pytest.raises(AttributeError):
            setattr(owner, name, 3)
        with pytest.raises(AttributeError):
            delattr(owner, name)
        assert getattr(owner, name) == before
    cls.note = "what is no constant can be"
    del cls.note


@pytest.mark.parametrize("line", ["string[] x ['a']", "int16[] x [1]", "uint8[2] x [1, 2]"])
def test_a_default_is_a_constant_like_its_field(line: str) -> None:
    cls: Any = define(line)
    assert repr(cls.X__DEFAULT) == repr(cls().x)
    assert cls.X__DEFAULT is not cls().x


def test_public_names_are_those_of_ros() -> None:
    cls: Any = define("int32 SPEC=1\nint32 TYPE_NAME=2\nint32 x")
    ours = {"SLOT_TYPES", "get_fields_and_field_types"}
    assert {name for name in dir(cls) if name[0] != "_"} == {"SPEC", "TYPE_NAME", "x", *ours}
    assert (cls.SPEC, cls.TYPE_NAME) == (1, 2)
    assert repr(copy.copy(cls(x=3))) == "demo_msgs.msg.Demo(x=3)"
    service = get_service("std_srvs/srv/SetBool")
    assert {name for name in dir(service) if name[0] != "_"} == {"Event", "Request", "Response"}


def test_a_message_with_the_field_duplicate_can_be_copied() -> None:
    cls: Any = define("bool duplicate")
    assert copy.deepcopy(cls(duplicate=True)).duplicate


@pytest.mark.parametrize(
    "name",
    ["args", "kwargs", "value", "other", "cls", "float", "int", "range", "array", "property", "x"],
)
def test_any_name_can_be_the_name_of_a_field(name: str) -> None:
    cls = define(f"float64 before\nfloat64 {name}\nint32[] after\nbool[2] last\nstring text 'a'")
    message = cls(before=1, **{name: 2}, after=[3])
    assert (message.before, getattr(message, name), message.after.tolist()) == (1.0, 2.0, [3])
    setattr(message, name, 4)
    assert copy.deepcopy(message) == message
    assert f"{name}=4.0" in repr(message)


def test_a_service_is_a_namespace() -> None:
    service: Any = get_service("std_srvs/srv/SetBool")
    assert service.Request._TYPE_NAME == "std_srvs/srv/SetBool_Request"
    assert service.Response(success=True, message="on").success
    assert service.Event().request == []
    assert service.Event is get_interface("std_srvs/srv/SetBool_Event")
    assert service.__module__ == service.Request.__module__ == "std_srvs.srv._set_bool"
    with pytest.raises(NotImplementedError):
        service()


def test_an_action_is_a_namespace() -> None:
    action: Any = get_action("example_interfaces/action/Fibonacci")
    assert action.Goal(order=3).order == 3
    assert action.Result().sequence == array("i")
    assert action.Feedback._TYPE_NAME == "example_interfaces/action/Fibonacci_Feedback"
    impl = action.Impl
    assert impl.SendGoalService.Request(goal=action.Goal(order=3)).goal.order == 3
    assert impl.GetResultService.Response().status == 0
    assert impl.FeedbackMessage().feedback == action.Feedback()
    assert impl.CancelGoalService is get_service("action_msgs/srv/CancelGoal")
    assert impl.GoalStatusMessage is get_message("action_msgs/msg/GoalStatusArray")
    with pytest.raises(NotImplementedError):
        action()


@pytest.mark.parametrize(
    ("name", "module"),
    [
        ("std_msgs/msg/String", "std_msgs.msg._string"),
        ("std_msgs/msg/UInt8MultiArray", "std_msgs.msg._u_int8_multi_array"),
        ("std_msgs/msg/ColorRGBA", "std_msgs.msg._color_rgba"),
        ("sensor_msgs/msg/PointCloud2", "sensor_msgs.msg._point_cloud2"),
        ("unique_identifier_msgs/msg/UUID", "unique_identifier_msgs.msg._uuid"),
        ("std_srvs/srv/SetBool_Request", "std_srvs.srv._set_bool"),
        ("test_msgs/action/NestedMessage_SendGoal_Request", "test_msgs.action._nested_message"),
    ],
)
def test_modules_are_named_as_in_ros(name: str, module: str) -> None:
    assert module_name(name) == module


def test_classes_are_found_once() -> None:
    assert get_message("std_msgs/String") is get_message("std_msgs/msg/String")
    assert issubclass(get_message("std_msgs/msg/String"), Message)


def test_a_traceback_shows_the_generated_line() -> None:
    cls: Any = get_message("geometry_msgs/msg/Vector3")
    with pytest.raises(FieldTypeError) as caught:
        cls().x = "fast"
    frames = traceback.extract_tb(caught.value.__traceback__)
    generated = next(frame for frame in frames if frame.filename.startswith("<zbot"))
    assert generated.filename == "<zbot geometry_msgs/msg/Vector3>"
    assert "self._x" in (generated.line or "")
    assert linecache.getline(generated.filename, 1).startswith("class Vector3")


def test_help_shows_the_definition() -> None:
    doc = get_message("geometry_msgs/msg/Vector3").__doc__ or ""
    assert doc.startswith("geometry_msgs/msg/Vector3\n")
    assert "float64 x" in doc


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: SetBool(data=True), r"write SetBool.Request\(data=...\)$"),
        (
            lambda: SetBool(success=True, message=""),
            r"write SetBool.Response\(success=..., message",
        ),
        (lambda: Fibonacci(sequence=[1]), r"write Fibonacci.Result\(sequence=...\)$"),
        (Fibonacci, r"write Fibonacci.Goal\(\)$"),
        (lambda: SetBool(no=1), r"write SetBool.Request\(no=...\)$"),
    ],
)
def test_a_service_or_action_class_names_the_part_to_write(
    make: Callable[[], object], text: str
) -> None:
    with pytest.raises(NotImplementedError, match=text):
        make()
