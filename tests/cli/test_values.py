"""Tests of values, filters and types on a command line."""

from __future__ import annotations

import contextlib
import math
from typing import Any

import hypothesis
import pytest
from hypothesis import strategies

import zbot  # noqa: F401 - makes the message packages importable
from zbot_cli.domain.kinds import TOPIC
from zbot_cli.domain.types import looks_like_type
from zbot_cli.errors import CommandError
from zbot_cli.input.filter import Filter
from zbot_cli.input.message_values import PopulateError, Template, ValuesError, split_documents

from geometry_msgs.msg import PoseArray, PoseStamped, PoseWithCovariance  # isort: skip
from geometry_msgs.msg import Twist, Vector3  # isort: skip
from sensor_msgs.msg import JointState  # isort: skip
from std_msgs.msg import Bool, Byte, ByteMultiArray, Empty, Float32  # isort: skip
from std_msgs.msg import Header, Int8, String, UInt8MultiArray  # isort: skip

NOW_NS = 5_000_000_007


def make(message_type: type[Any], *words: str) -> Any:
    return Template(message_type, words).make(lambda: NOW_NS)


@pytest.mark.parametrize(
    "text",
    [
        "{linear: {x: 2.0}, angular: {z: 1.8}}",
        '{"linear": {"x": 2.0}, "angular": {"z": 1.8}}',
        "linear:\n  x: 2.0\nangular:\n  z: 1.8\n",
        "linear.x=2 angular.z=1.8",
    ],
)
def test_a_twist_can_be_written_in_several_forms(text: str) -> None:
    message = make(Twist, text)
    assert (message.linear.x, message.linear.y, message.angular.z) == (2.0, 0.0, 1.8)


@pytest.mark.parametrize("text", ["", "{}", "   "])
def test_an_empty_text_gives_default_values(text: str) -> None:
    assert make(Twist, text) == Twist()


@pytest.mark.parametrize(
    ("message_type", "text", "wanted"),
    [
        (String, "data: 5", "5"),
        (String, "data: true", "true"),
        (String, "data: ", ""),
        (Float32, "data: 1", 1.0),
        (Float32, "data: '2.5'", 2.5),
        (Int8, "data: 3.0", 3),
        (Bool, "data: true", True),
        (Bool, "data: 1", True),
        (String, "data: 12:30", "12:30"),
        (String, "data: yes", "yes"),
        (String, "data: 007", "007"),
        (String, "data: 2024-13-01", "2024-13-01"),
        (String, "data: !!bool abc", "abc"),
        (String, "data: !!timestamp abc", "abc"),
        (String, "data: 'a: b'", "a: b"),
        (String, "data: 🤖", "🤖"),
        (Float32, "data: 1e3", 1000.0),
        (Float32, "data: .inf", float("inf")),
        (Int8, "data: 0x10", 16),
        (Byte, "data: 65", b"A"),
    ],
)
def test_values_are_cast_to_the_field(message_type: type[Any], text: str, wanted: object) -> None:
    assert make(message_type, text).data == wanted


def test_a_header_can_be_filled_with_now() -> None:
    for text in ("{header: auto}", "{header: {stamp: now}}"):
        stamp = make(PoseStamped, text).header.stamp
        assert (stamp.sec, stamp.nanosec) == (5, 7)


def test_a_template_knows_whether_its_messages_contain_the_time() -> None:
    assert Template(PoseStamped, "{header: auto}").is_stamped
    assert Template(PoseStamped, "{header: {stamp: now}}").is_stamped
    assert not Template(PoseStamped, "{header: {frame_id: now}}").is_stamped
    assert not Template(String, "data: auto").is_stamped


def test_a_template_makes_a_new_message_with_the_time_of_each_call() -> None:
    template = Template(Header, "stamp: now")
    moments = iter((10**9, 2 * 10**9))
    assert [template.make(lambda: next(moments)).stamp.sec for _ in range(2)] == [1, 2]


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        (["data=hello"], "hello"),
        (["data=hello world"], "hello world"),
        (["data=a: b"], "a: b"),
        (["data='quoted'"], "quoted"),
        (["data="], ""),
        (["data:", "hello"], "hello"),
    ],
)
def test_words_of_the_command_line_set_fields(words: list[str], wanted: str) -> None:
    assert make(String, *words).data == wanted


def test_words_may_contain_lists_and_come_in_any_order() -> None:
    message = make(JointState, "position=[1, 2.5]", "header.frame_id=map", "name=[a, b]")
    assert (message.name, list(message.position)) == (["a", "b"], [1.0, 2.5])
    assert message.header.frame_id == "map"


def test_bytes_are_lists_or_base64_as_json_shows_them() -> None:
    for text in ("{data: [65, 66]}", "{data: QUI=}"):
        assert bytes(make(UInt8MultiArray, text).data) == b"AB"
        assert make(ByteMultiArray, text).data == [b"A", b"B"]


def test_null_is_nan_for_floats_as_json_shows_it() -> None:
    assert math.isnan(make(Float32, "{data: null}").data)
    assert math.isnan(make(JointState, "{position: [1, ~]}").position[1])
    with pytest.raises(PopulateError, match=r"data must be an int .*, not 'null'"):
        make(Int8, "{data: null}")


def test_a_number_that_no_float_can_hold_is_refused() -> None:
    with pytest.raises(PopulateError, match="not '1e999'"):
        make(Float32, "{data: 1e999}")


def test_a_list_of_messages_is_set_by_dictionaries() -> None:
    message = make(PoseArray, "{poses: [{position: {x: 1}}, {}], header: auto}")
    assert [pose.position.x for pose in message.poses] == [1.0, 0.0]
    assert message.poses[1].orientation.w == 1.0


def test_a_given_list_replaces_the_default() -> None:
    message = make(JointState, "{name: [a, b], position: [1, 2.5]}")
    assert (message.name, list(message.position)) == (["a", "b"], [1.0, 2.5])


@pytest.mark.parametrize(
    ("message_type", "text", "sentence", "hint"),
    [
        (String, "{dat: x}", "'String' object has no attribute 'dat'", "did you mean 'data'?"),
        (
            Float32,
            "{data:1}",
            "no attribute 'data:1' (line 1, column 2)\n  {data:1}\n   ^",
            "put a blank after the colon: data: 1",
        ),
        (Float32, "{data: abc}", "data must be a float within float32's range, not 'abc'", None),
        (Int8, "{data: 200}", "200", None),
        (Int8, "{data: 1.5}", "data must be an int from -128 to 127, not '1.5'", None),
        (
            Bool,
            "{data: maybe}",
            "data must be a bool, not 'maybe'",
            "data is a bool: write data: true",
        ),
        (Twist, "{linear: 3}", "Value '3' is expected to be a dictionary but is a int", None),
        (
            Twist,
            "{linear: }",
            "Value 'None' is expected to be a dictionary but is a NoneType",
            None,
        ),
        (Twist, "{linear: [1, 2]}", "Value '[1, 2]' is expected to be a dictionary", None),
        (
            Twist,
            "{linear: {x: fast}}",
            "linear.x must be a float, not 'fast'",
            "linear.x is a float64: write x: 1.5",
        ),
        (
            Int8,
            "{data: x}",
            "data must be an int from -128 to 127, not 'x'",
            "data is an int8: write data: 2",
        ),
        (Float32, "{data: true}", "data must be a float within float32's range, not 'true'", None),
        (Float32, "{data: }", "data must be a float within float32's range, not nothing", None),
        (
            String,
            "{data: {hello}}",
            "data must be a str, not {'hello': ''}",
            "put the text of data in quo",
        ),
        (JointState, "{name: a}", "name must be a list, of which each is a str, not 'a'", None),
        (JointState, "{position: [1, b]}", "position[1] must be a float, not 'b'", None),
        (
            UInt8MultiArray,
            "{data: '!'}",
            "data must be base64 or a list, of which each is an int from 0 to 255",
            None,
        ),
        (UInt8MultiArray, "{data: [300]}", "300", None),
        (Empty, "{a: 1}", "'Empty' object has no attribute 'a'", "it has no fields"),
    ],
)
def test_a_value_of_a_wrong_type_is_refused(
    message_type: type[Any], text: str, sentence: str, hint: str | None
) -> None:
    with pytest.raises(PopulateError) as caught:
        make(message_type, text)
    assert sentence in str(caught.value)
    if hint is not None:
        assert str(caught.value.hint).startswith(hint)


@pytest.mark.parametrize(
    ("message_type", "text", "expected"),
    [
        (Twist, "{linear:{x: 2.0}}", Twist(linear=Vector3(x=2.0))),
        (JointState, "{name:[a], position:[1.5]}", JointState(name=["a"], position=[1.5])),
        (String, "{data: y}", String(data="y")),
        (String, "{data: 08}", String(data="08")),
        (String, "{data:\ta\tb}", String(data="a\tb")),
    ],
)
def test_what_ros2_reads_is_read(message_type: type[Any], text: str, expected: object) -> None:
    assert Template(message_type, text).make(lambda: 0) == expected


@pytest.mark.parametrize(
    ("message_type", "text", "sentence", "hint"),
    [
        (Twist, "{linear: {x: 2,0}}", "'2,0' is not a number", "not a comma: x: 2.0"),
        (Twist, "linear: {x: 1, y: -2,5e3}", "'-2,5e3' is not a number", "y: -2.5e3"),
        (Int8, "{data: 1,000}", "'1,000' is not a number", "write data: 1000 or data: 1.000"),
        (Float32, "data: 2,5", "range, not '2,5'", "data: 2.5"),
        (String, "{data: hello, world}", "'world' has no value", "quotes: data: 'hello, world'"),
        (JointState, "{position: 1.0, 2.0}", "'2.0' has no value", "position: [1.0, 2.0]"),
        (JointState, "{position: 1.0}", "position must be a list", "write position: [1.0]"),
        (Twist, "{linear: {x= 2.0}}", "(line 1, column 11)", "not '=': x: 2.0"),
        (Twist, "{linear: {x: 2.0}", "not YAML", "add } at the end"),
        (Twist, "{linear: {x: 2.0}}}", "not YAML", "remove }"),
        (JointState, "{position: [1.0}", "not YAML", "add ] at the end"),
        (Twist, "{linear: {x: 1; y: 2}}", "not YAML", "a comma, not ';'"),
        (Twist, "{linear: {x: 1 y: 2}}", "not YAML", "a comma between two fields"),
        (Twist, "linear: {x: 1} angular: {z: 1}", "not YAML", "one pair of braces around all"),
        (Float32, "{data: 2} std_msgs/Float32", "not YAML", 'values: std_msgs/Float32 "{data: 2}"'),
        (Twist, "linear: x: 1", "not YAML", 'write it like "{linear: {x: 2.0}}"'),
        (Twist, "{linear: {X: 1}}", "no attribute 'X'", "did you mean 'x'?"),
        (Twist, "5", "needs to be a dictionary", '"{linear: ..., angular: ...}"'),
    ],
)
def test_a_malformed_text_says_what_to_type(
    message_type: type[Any], text: str, sentence: str, hint: str
) -> None:
    with pytest.raises((PopulateError, ValuesError)) as caught:
        make(message_type, text)
    assert sentence in str(caught.value)
    assert hint in str(getattr(caught.value, "hint", ""))


@pytest.mark.parametrize("text", ["abc", "[1, 2]", "5"])
def test_a_value_that_is_not_a_dictionary_is_refused(text: str) -> None:
    with pytest.raises(ValuesError, match="needs to be a dictionary in YAML format"):
        make(String, text)


def test_a_syntax_error_points_at_its_place() -> None:
    with pytest.raises(ValuesError) as caught:
        make(String, "{data: [1}")
    assert str(caught.value).endswith("(line 1, column 10)\n  {data: [1}\n           ^")


def test_a_missing_bracket_is_pointed_out_at_the_end_of_the_text() -> None:
    with pytest.raises(ValuesError) as caught:
        make(Twist, "{linear: {x: 1.0}")
    assert str(caught.value).endswith(
        "(line 1, column 18)\n  {linear: {x: 1.0}\n                   ^"
    )


def test_a_missing_blank_is_found_without_braces() -> None:
    with pytest.raises(ValuesError) as caught:
        make(String, "data:hello")
    assert caught.value.hint == "put a blank after the colon: 'data: hello'"


@pytest.mark.parametrize(
    "words", [["{data: a, data: b}"], ["data=a", "data=b"], ["linear=1", "linear.x=2"]]
)
def test_two_values_for_one_field_are_refused(words: list[str]) -> None:
    with pytest.raises(ValuesError, match="has two values"):
        make(String, *words)


@pytest.mark.parametrize("text", ["{data: !!python/name:os.system x}", "{data: !own x}", "{*a: 1}"])
def test_tags_and_aliases_are_refused(text: str) -> None:
    with pytest.raises((ValuesError, PopulateError)):
        make(String, text)


@hypothesis.given(strategies.text(max_size=30))
def test_any_text_is_a_message_or_one_error(text: str) -> None:
    with contextlib.suppress(ValuesError, PopulateError):
        assert isinstance(make(Twist, text), Twist)


@hypothesis.given(strategies.text(alphabet="{}[]:,'\"\n- data=x1&*!|>%@#?", max_size=30))
def test_any_yaml_like_text_is_a_message_or_one_error(text: str) -> None:
    with contextlib.suppress(ValuesError, PopulateError):
        assert isinstance(make(String, text), String)


def test_the_output_of_echo_is_split_into_documents() -> None:
    assert split_documents("data: a\n---\ndata: b\n---\n") == ["data: a\n", "\ndata: b\n"]


# -- filters ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("expression", "wanted"),
    [
        ("m.linear.x > 1", True),
        ("m.linear.x > 1 and m.angular.z < 0", False),
        ("not m.linear.x == 2.0", False),
        ("abs(m.angular.z) + 1 >= 2.8", True),
        ("1 < m.linear.x < 3", True),
        ("m.linear.x in [1, 2]", True),
        ("-m.linear.x < 0", True),
        ("m.linear.x % 2 == 0", True),
    ],
)
def test_filters_compare_and_calculate(expression: str, wanted: bool) -> None:
    assert Filter(expression).accepts(make(Twist, "linear.x=2 angular.z=1.8")) is wanted


@pytest.mark.parametrize(
    ("expression", "wanted"),
    [
        ("int(m.data.rpartition(':')[-1]) % 2 == 0", True),
        ("float(m.data.split(':')[1]) > 42.5", False),
        ("m.data.startswith('x') or not m.data.lower().endswith('42')", False),
    ],
)
def test_filters_search_in_texts(expression: str, wanted: bool) -> None:
    wanting = Filter(expression)
    wanting.check(String, lambda message: message)
    assert wanting.accepts(String(data="Count: 42")) is wanted


@pytest.mark.parametrize(
    "expression",
    [
        "__import__('os')",
        "m.data.zfill(10**9)",
        "m.data.format(m)",
        "m.data.split(sep=':')",
        "m.__class__",
        "open('x')",
        "m.linear._x",
        "(lambda: 1)()",
        "[x for x in m]",
        "m.linear.x ** 1000000",
        "f'{m}'",
        "exec('1')",
        "x > 1",
        "m.x(",
        "len(m, key=1)",
        "1 if m else 2",
        "+".join("1" for _ in range(500)),
    ],
)
def test_a_filter_refuses_all_other_expressions(expression: str) -> None:
    with pytest.raises(CommandError, match="Invalid filter expression"):
        Filter(expression)


@pytest.mark.parametrize(
    "expression",
    ["m.nope > 1", "m.linear > 1", "m.linear.x / 0", "'a' * 9 == m", "m.linear.find(1)"],
)
def test_a_filter_that_does_not_fit_is_refused_at_the_first_message(expression: str) -> None:
    with pytest.raises(CommandError):
        Filter(expression).accepts(Twist())


@pytest.mark.parametrize("expression", ["max > 1", "round(m.linear.x, -10**9)", "m.linear.SPEC"])
def test_a_filter_can_use_fields_only(expression: str) -> None:
    with pytest.raises(CommandError):
        Filter(expression).accepts(Twist())


@pytest.mark.parametrize(
    ("expression", "message_type"),
    [
        ("m.nope > 1", Twist),
        ("m.linear > 1", Twist),
        ("m.linear.x.real > 1", Twist),
        ("m.poses.length > 1", PoseArray),
    ],
)
def test_an_impossible_filter_is_refused_before_the_first_message(
    expression: str, message_type: type[Any]
) -> None:
    with pytest.raises(CommandError):
        Filter(expression).check(message_type, lambda message: message)


@pytest.mark.parametrize(
    ("expression", "message_type"),
    [
        ("m.poses[3].position.x > 1", PoseArray),
        ("1 / m.linear.x > 1", Twist),
        ("max(m.position) > 1", JointState),
        ("m.covariance[0] + 1 > 0", PoseWithCovariance),
    ],
)
def test_a_filter_that_may_fit_is_accepted_before_the_first_message(
    expression: str, message_type: type[Any]
) -> None:
    Filter(expression).check(message_type, lambda message: message)


def test_a_filter_calculates_with_elements_of_fixed_arrays() -> None:
    assert Filter("m.covariance[0] + 1 == 1").accepts(PoseWithCovariance())


# -- types -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("word", ["std_msgs/msg/String", "std_msgs/String", "std_msgs.msg.String"])
def test_types_can_be_written_in_three_forms(word: str) -> None:
    assert looks_like_type(word)
    assert TOPIC.resolve_type(word) == "std_msgs/msg/String"


def test_a_unique_short_name_is_enough() -> None:
    assert TOPIC.resolve_type("TwistWithCovarianceStamped").startswith("geometry_msgs/msg/")
    with pytest.raises(CommandError) as caught:
        TOPIC.resolve_type("String")
    assert caught.value.hint is not None
    assert "std_msgs/msg/String" in caught.value.hint


@pytest.mark.parametrize("word", ["{data: 1}", "data: 1", "linear.x=2", "data"])
def test_values_are_not_taken_for_types(word: str) -> None:
    assert not looks_like_type(word)


def test_quotes_of_a_word_processor_are_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert make(String, "{data: “hi”}").data == "“hi”"
    assert capsys.readouterr().err == (
        "note: the text is “hi”: type ' in place of “ and ” if they are not a part of it\n"
    )
    make(String, "{data: 'he said “hi” to me'}")
    assert capsys.readouterr().err == ""
