from __future__ import annotations

import contextlib
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.conftest import allowed
from zbot.interfaces.errors import InterfaceSyntaxError
from zbot.interfaces.parser import (
    parse,
    parse_action,
    parse_message,
    parse_service,
    split_comment,
)
from zbot.interfaces.spec import ActionSpec, FieldType, MessageSpec, Scalar, ServiceSpec


def parsed(text: str) -> MessageSpec:
    return parse_message("demo_msgs/msg/Demo", text)


@pytest.mark.parametrize(
    ("text", "expected", "as_ros_shows_it"),
    [
        ("float64", FieldType("float64"), "double"),
        ("float32[]", FieldType("float32", "sequence"), "sequence<float>"),
        ("bool[<=3]", FieldType("bool", "sequence", 3), "sequence<boolean, 3>"),
        ("uint8[16]", FieldType("uint8", "array", 16), "uint8[16]"),
        ("byte", FieldType("byte"), "octet"),
        ("char", FieldType("char"), "uint8"),
        ("wstring", FieldType("wstring"), "wstring"),
        ("string<=10", FieldType("string", string_bound=10), "string<10>"),
        ("string<=10[]", FieldType("string", "sequence", 0, 10), "sequence<string<10>>"),
        ("string<=10[<=5]", FieldType("string", "sequence", 5, 10), "sequence<string<10>, 5>"),
        ("string[2]", FieldType("string", "array", 2), "string[2]"),
        ("Other", FieldType("demo_msgs/msg/Other"), "demo_msgs/Other"),
        ("Header", FieldType("std_msgs/msg/Header"), "std_msgs/Header"),
        ("geometry_msgs/Point[3]", FieldType("geometry_msgs/msg/Point", "array", 3),
         "geometry_msgs/Point[3]"),
        ("geometry_msgs/msg/Point", FieldType("geometry_msgs/msg/Point"), "geometry_msgs/Point"),
    ],
)  # fmt: skip
def test_field_types_are_parsed(text: str, expected: FieldType, as_ros_shows_it: str) -> None:
    (field,) = parsed(f"{text} value").fields
    assert field.type == expected
    assert str(field.type) == as_ros_shows_it


@pytest.mark.parametrize(
    "text",
    ["float64[3]", "string<=4[<=2]", "int8[]", "bool", "char", "geometry_msgs/Point[<=7]"],
)
def test_a_type_is_written_as_it_was_read(text: str) -> None:
    assert parsed(f"{text} value").fields[0].type.text == text


@pytest.mark.parametrize(
    ("line", "value"),
    [
        ("bool a true", True),
        ("bool a False", False),
        ("bool a 1", True),
        ("int32 a -7", -7),
        ("int32 a 007", 7),
        ("uint8 a 0xff", 255),
        ("byte a 3", b"\x03"),
        ("char a 65", 65),
        ("float64 a 1", 1.0),
        ("float64 a -1e3", -1000.0),
        ("float32 a inf", float("inf")),
        ("string a plain words", "plain words"),
        ("string a 'with # inside'  # and a comment", "with # inside"),
        ('string a "it\'s"', "it's"),
        (r"string a 'it\'s'", "it's"),
        (r'string a "a \"b\" c"', 'a "b" c'),
        (r"string a 'a\tb'", "a\tb"),
        (r"string a 'a\\b\\'", "a\\b\\"),
        (r"string a x\n\x41\101\u00e9\N{BULLET}\q", "x\nAAé•\\q"),
        (r"string[] a ['a\n', b]", ("a\n", "b")),
        (r"wstring a 'é\n'", "é\n"),
        ("float32 a 3.4028235e38", 3.4028234663852886e38),
        ("float64 a 1e400", float("inf")),
        ("float64[] a [-inf, 1]", (float("-inf"), 1.0)),
        ("int8 a -0x80", -128),
        ("int64 a 010", 10),
        ("string a '  spaces  '", "  spaces  "),
        ('string a "x = 1"', "x = 1"),
        ("string a ''", ""),
        ("int32[] a []", ()),
        ("int32[3] a [1, 2,3]", (1, 2, 3)),
        ("float64[<=3] a [1, 2.5]", (1.0, 2.5)),
        ("byte[] a [0, 255]", (b"\x00", b"\xff")),
        ("string[] a ['a, b', \"c\", d]", ("a, b", "c", "d")),
        (r"string[] a ['it\'s']", ("it's",)),
    ],
)
def test_default_values_are_parsed(line: str, value: Scalar | tuple[Scalar, ...]) -> None:
    (field,) = parsed(line).fields
    assert field.default == value
    assert type(field.default) is type(value)


@pytest.mark.parametrize(
    ("line", "name", "value"),
    [
        ("int32 X=5", "X", 5),
        ("int32 X = -5 # five", "X", -5),
        ("uint8 X_2=0x10", "X_2", 16),
        ("string X=plain", "X", "plain"),
        ("string X = 'quoted # text'", "X", "quoted # text"),
        ("string X=don't  # unquoted", "X", "don't"),
        ("string X=", "X", ""),
        ("float32 PI=3.14", "PI", 3.14),
        ("byte OK=0", "OK", b"\x00"),
        ("bool YES=true", "YES", True),
    ],
)
def test_constants_are_parsed(line: str, name: str, value: Scalar) -> None:
    (constant,) = parsed(line).constants
    assert (constant.name, constant.value) == (name, value)
    assert type(constant.value) is type(value)


def test_a_message_keeps_order_lines_and_text() -> None:
    text = "# About it.\n\nint32 A=1\n\tfloat64  x 1.5 # metres\r\nOther y"
    spec = parsed(text)
    assert [(field.name, field.line) for field in spec.fields] == [("x", 4), ("y", 5)]
    assert [(constant.name, constant.line) for constant in spec.constants] == [("A", 3)]
    assert spec.text == text
    assert spec.package == "demo_msgs"


def test_a_service_is_two_messages_and_an_event() -> None:
    spec = parse_service("demo_msgs/srv/Add", "int64 a\n---\nint64 sum # of all\n")
    assert spec.request.name == "demo_msgs/srv/Add_Request"
    assert [field.name for field in spec.request.fields] == ["a"]
    assert [(field.name, field.line) for field in spec.response.fields] == [("sum", 3)]
    assert [str(field.type) for field in spec.event.fields] == [
        "service_msgs/ServiceEventInfo",
        "sequence<demo_msgs/Add_Request, 1>",
        "sequence<demo_msgs/Add_Response, 1>",
    ]


def test_an_action_is_three_messages_with_the_services_that_carry_them() -> None:
    spec = parse_action("demo_msgs/action/Count", "int32 n\n---\nint32 last\n---\nint32 now\n")
    assert [part.name for part in (spec.goal, spec.result, spec.feedback)] == [
        "demo_msgs/action/Count_Goal",
        "demo_msgs/action/Count_Result",
        "demo_msgs/action/Count_Feedback",
    ]
    shapes = {
        part.name: [(field.name, str(field.type)) for field in part.fields]
        for part in (
            spec.send_goal.request,
            spec.send_goal.response,
            spec.get_result.request,
            spec.get_result.response,
            spec.feedback_message,
        )
    }
    uuid = ("goal_id", "unique_identifier_msgs/UUID")
    assert shapes == {
        "demo_msgs/action/Count_SendGoal_Request": [uuid, ("goal", "demo_msgs/Count_Goal")],
        "demo_msgs/action/Count_SendGoal_Response": [
            ("accepted", "boolean"),
            ("stamp", "builtin_interfaces/Time"),
        ],
        "demo_msgs/action/Count_GetResult_Request": [uuid],
        "demo_msgs/action/Count_GetResult_Response": [
            ("status", "int8"),
            ("result", "demo_msgs/Count_Result"),
        ],
        "demo_msgs/action/Count_FeedbackMessage": [uuid, ("feedback", "demo_msgs/Count_Feedback")],
    }


@pytest.mark.parametrize(
    ("name", "text", "kind"),
    [
        ("demo_msgs/msg/Demo", "", MessageSpec),
        ("demo_msgs/srv/Demo", "---", ServiceSpec),
        ("demo_msgs/action/Demo", "---\n---", ActionSpec),
    ],
)
def test_the_file_name_gives_the_kind(name: str, text: str, kind: type) -> None:
    assert isinstance(parse(name, text), kind)


@pytest.mark.parametrize(
    ("line", "hint"),
    [
        ("int32", "only one word"),
        ("int32 a;", "int32 a;"),
        ("float x", "write float64"),
        ("flaot64 x", "did you mean 'float64'"),
        ("int32 MyField", "e.g. 'my_field'"),
        ("int32 my__field", "single underscores"),
        ("int32 class", "reserved in Python"),
        ("int32 self", "reserved in Python"),
        ("int32 speed = 5", "must be upper case: 'SPEED'"),
        ("int32 speed = 5", "leave out the '=': 'speed 5'"),
        ("int8 x 200", "from -128 to 127"),
        ("uint8 x -1", "from 0 to 255"),
        ("int32 x 1.5", "whole number"),
        ("int32 x " + "9" * 5000, "whole number"),
        ("float32 x 1e300", "write float64"),
        ("float64 x 1,5", "'.' as its decimal point"),
        ("bool x yes", "true or false"),
        ("string x 'open", "must end with '"),
        ("string x 'it's'", r"write \'"),
        ("string<=3 x abcd", "at most 3 characters"),
        ("int32[2] x [1]", "2 values are needed"),
        ("int32[<=2] x [1, 2, 3]", "at most 2 values"),
        ("int32[] x 1", "a list such as"),
        ("string[] x ['a' 'b']", "cannot read the list"),
        ("int32[] X=[1]", "not an array"),
        ("Other x 1", "cannot have a default"),
        ("int32[0] x", "from 1 to"),
        ("int32[-1] x", "from 1 to"),
        ("uint8[9999999999] x", "from 1 to"),
        ("int32<=5 x", "'int32[<=10]'"),
        ("string<=x x", "the bound of"),
        ("Geometry_msgs/Point x", "package name"),
        ("geometry_msgs/point x", "e.g. 'Point'"),
        ("a/b/c/D x", "package/Name"),
        ("time stamp", "builtin_interfaces/Time"),
        ("---", "exactly three dashes"),
    ],
)
def test_a_mistake_is_reported_with_its_place_and_a_hint(line: str, hint: str) -> None:
    with pytest.raises(InterfaceSyntaxError) as caught:
        parse_message("demo_msgs/msg/Demo", f"# first\n{line}\n", "msg/Demo.msg")
    assert (caught.value.file, caught.value.line) == ("msg/Demo.msg", 2)
    assert str(caught.value).startswith("msg/Demo.msg:2: ")
    assert hint in str(caught.value)


def test_a_second_declaration_is_refused_with_the_first() -> None:
    with pytest.raises(InterfaceSyntaxError, match=r":3: 'a' is already declared in line 1"):
        parsed("int32 a\n\nfloat64 a")


@pytest.mark.parametrize(
    ("name", "text", "hint"),
    [
        ("demo_msgs/srv/Demo", "int32 a", "one line '---' is needed"),
        ("demo_msgs/srv/Demo", "---\n---", "there are 2"),
        ("demo_msgs/action/Demo", "---", "2 lines '---' are needed"),
        ("demo_msgs/msg/demo", "", "e.g. 'Demo'"),
        ("DemoMsgs/msg/Demo", "", "e.g. 'demo_msgs'"),
        ("demo_msgs/Demo", "", "package/msg/Name"),
        ("demo_msgs/msg/Demo", "string x '\ud800'", "UTF-8"),
    ],
)
def test_a_definition_with_a_wrong_structure_is_refused(name: str, text: str, hint: str) -> None:
    with pytest.raises(InterfaceSyntaxError) as caught:
        parse(name, text)
    assert caught.value.line == 0
    assert hint in str(caught.value)


@pytest.mark.parametrize(
    ("line", "code", "comment"),
    [
        ("int32 x  # why", "int32 x", "# why"),
        ("# only", "", "# only"),
        ("string s '#'", "string s '#'", ""),
        ("string s don't # c", "string s don't", "# c"),
        ("", "", ""),
    ],
)
def test_comments_are_split_off(line: str, code: str, comment: str) -> None:
    assert split_comment(line) == (code, comment)


_TOKENS = r"""int32 string string<= Header float64[ ] [ <= = x X ' " # --- \ 5 A/B true 1e9"""
_WORDS = st.sampled_from([*_TOKENS.split(), " ", "\n", "\t"])
_TEXTS = st.one_of(st.text(), st.lists(_WORDS).map("".join), st.lists(_WORDS).map(" ".join))


@pytest.mark.parametrize("kind", ["msg", "srv", "action"])
@given(text=_TEXTS)
def test_any_text_is_read_or_refused(kind: str, text: str) -> None:
    with contextlib.suppress(InterfaceSyntaxError):
        parse(f"demo_msgs/{kind}/Demo", text)


@given(st.text())
def test_any_name_is_taken_or_refused(name: str) -> None:
    with contextlib.suppress(InterfaceSyntaxError):
        parse_message(name, "")


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("string A='a", "the string begins with ' and must end with '"),
        (r"string A='a\'", "the string begins with ' and must end with '"),
        ("string A='a'b'", r"write \\' for a quote inside"),
        (r"string A=\ud800", "is not a character"),
        (r"string A=\N{NO SUCH NAME}", "is not a character"),
        ("float32 A=1e39", "too large for a float32"),
        ("uint8 A=0x100", "write a whole number from 0 to 255"),
        ("int8 a -129", "write a whole number from -128 to 127"),
        ("bool A=yes", "a bool is true or false"),
    ],
)
def test_a_value_that_does_not_fit_its_type_is_named_with_file_and_line(
    line: str, reason: str
) -> None:
    with pytest.raises(InterfaceSyntaxError, match=rf"Odd\.msg:2: .*{reason}"):
        parse_message("demo_msgs/msg/Odd", f"int32 b\n{line}\n", "Odd.msg")


def test_many_names_of_characters_without_an_end_take_little_time() -> None:
    begin = time.process_time()
    text = "\\N{" * 80_000
    spec = parse_message("demo_msgs/msg/Odd", f"string A={text}\nstring b '{text}'")
    assert spec.constants[0].value == spec.fields[0].default == text
    assert time.process_time() - begin < allowed(3)
