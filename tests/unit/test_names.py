from __future__ import annotations

from collections.abc import Callable

import pytest

from zbot.errors import (
    ArgumentTypeError,
    InvalidNameError,
    InvalidNamespaceError,
    InvalidNodeNameError,
    InvalidParameterError,
    InvalidServiceNameError,
    InvalidTopicNameError,
)
from zbot.names import (
    expand_topic_name,
    fully_qualified,
    is_hidden,
    split_fully_qualified,
    validate_full_topic_name,
    validate_namespace,
    validate_node_name,
    validate_parameter_name,
    validate_topic_name,
)

Validator = Callable[[str], object]


@pytest.mark.parametrize(
    ("validate", "name"),
    [
        (validate_node_name, "lidar"),
        (validate_node_name, "_hidden_2"),
        (validate_node_name, "a" * 255),
        (validate_namespace, "/"),
        (validate_namespace, "/fleet/robot_1"),
        (validate_namespace, "/" + "a" * 244),
        (validate_topic_name, "chatter"),
        (validate_topic_name, "/robot/chatter"),
        (validate_topic_name, "~"),
        (validate_topic_name, "~/state"),
        (validate_topic_name, "{node}/x{ns}"),
        (validate_topic_name, "a//b"),
        (validate_topic_name, "_hidden/__x"),
        (validate_topic_name, "a" * 300),
        (validate_full_topic_name, "/a/b__c"),
        (validate_full_topic_name, "/" + "a" * 246),
        (validate_parameter_name, "qos_overrides./x.y"),
        (validate_parameter_name, "1 2"),
    ],
)
def test_names_that_ros_accepts_are_accepted(validate: Validator, name: str) -> None:
    assert validate(name) is True


# The index of each row is the one that ROS 2's own validators give.
@pytest.mark.parametrize(
    ("validate", "name", "index", "reason"),
    [
        (validate_node_name, "", 0, "must not be empty"),
        (validate_node_name, "1a", 0, "start with a number"),
        (validate_node_name, "a b", 1, "characters other than"),
        (validate_node_name, "/a", 0, "characters other than"),
        (validate_node_name, "é", 0, "characters other than"),
        (validate_node_name, "a" * 256, 255, "longer than 255"),
        (validate_namespace, "", 0, "must not be empty"),
        (validate_namespace, "foo", 0, "must be absolute"),
        (validate_namespace, "/foo/", 4, "must not end with '/'"),
        (validate_namespace, "/a//b", 3, "must not repeat '/'"),
        (validate_namespace, "/a/1", 3, "must not start with a number"),
        (validate_namespace, "/a b", 2, "characters other than"),
        (validate_namespace, "/" + "a" * 245, 245, "longer than 245"),
        (validate_topic_name, "", 0, "must not be empty"),
        (validate_topic_name, "foo bar", 3, "characters other than"),
        (validate_topic_name, "/", 0, "must not end with '/'"),
        (validate_topic_name, "~/", 1, "must not end with '/'"),
        (validate_topic_name, "1foo", 0, "must not start with a number"),
        (validate_topic_name, "foo/1bar", 4, "must not start with a number"),
        (validate_topic_name, "~foo", 1, "must have '/' after '~'"),
        (validate_topic_name, "foo/~", 4, "first character"),
        (validate_topic_name, "{node", 0, "without a '}'"),
        (validate_topic_name, "x{y", 1, "without a '}'"),
        (validate_topic_name, "node}", 4, "without a '{'"),
        (validate_topic_name, "{no de}", 3, "between '{' and '}'"),
        (validate_topic_name, "{{node}}", 1, "between '{' and '}'"),
        (validate_topic_name, "a{b/c}", 3, "between '{' and '}'"),
        (validate_topic_name, "{1a}", 1, "digit after '{'"),
        (validate_topic_name, "é", 0, "characters other than"),
        (validate_full_topic_name, "chatter", 0, "must be absolute"),
        (validate_full_topic_name, "/foo//bar", 5, "must not repeat '/'"),
        (validate_full_topic_name, "/{node}", 1, "characters other than"),
        (validate_full_topic_name, "/a/1", 3, "must not start with a number"),
        (validate_full_topic_name, "/" + "a" * 247, 247, "longer than 247"),
    ],
)
def test_bad_names_are_refused_at_their_first_bad_character(
    validate: Validator, name: str, index: int, reason: str
) -> None:
    with pytest.raises(InvalidNameError) as caught:
        validate(name)
    assert (caught.value.name, caught.value.invalid_index) == (name, index)
    assert reason in caught.value.error_msg


@pytest.mark.parametrize(
    ("validate", "error"),
    [
        (validate_node_name, InvalidNodeNameError),
        (validate_namespace, InvalidNamespaceError),
        (validate_topic_name, InvalidTopicNameError),
        (lambda name: validate_topic_name(name, is_service=True), InvalidServiceNameError),
        (lambda name: validate_full_topic_name(name, is_service=True), InvalidServiceNameError),
    ],
)
def test_each_kind_of_name_has_its_own_error(
    validate: Validator, error: type[InvalidNameError]
) -> None:
    with pytest.raises(error):
        validate("/not ok")


def test_the_message_points_at_the_character() -> None:
    with pytest.raises(InvalidTopicNameError) as caught:
        validate_topic_name("foo bar")
    lines = str(caught.value).splitlines()
    assert lines[0].startswith("Invalid topic name: topic name must not contain")
    assert lines[1:] == ["  'foo bar'", "      ^"]


def test_the_caret_counts_escaped_characters() -> None:
    with pytest.raises(InvalidTopicNameError) as caught:
        validate_full_topic_name("\n")
    assert str(caught.value).splitlines()[1:] == [r"  '\n'", "   ^"]


def test_a_name_that_is_not_a_string_is_a_type_error() -> None:
    with pytest.raises(ArgumentTypeError, match="node name must be a string, not int: 5"):
        validate_node_name(5)  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_an_empty_parameter_name_is_refused() -> None:
    with pytest.raises(InvalidParameterError, match="Invalid parameter name"):
        validate_parameter_name("")


@pytest.mark.parametrize(
    ("name", "namespace", "expected"),
    [
        ("scan", "/", "/scan"),
        ("scan", "/ns", "/ns/scan"),
        ("/scan", "/ns", "/scan"),
        ("~", "/", "/lidar"),
        ("~", "/ns", "/ns/lidar"),
        ("~/scan", "/ns", "/ns/lidar/scan"),
        ("~/{node}", "/", "/lidar/lidar"),
        ("{node}/scan", "/ns", "/ns/lidar/scan"),
        ("/{node}", "/ns", "/lidar"),
        ("{ns}/scan", "/ns", "/ns/scan"),
        ("{namespace}/scan", "/ns", "/ns/scan"),
        ("/{ns}/scan", "/ns", "//ns/scan"),
        ("a{ns}", "/ns", "/ns/a/ns"),
    ],
)
def test_expand_resolves_against_node_and_namespace(
    name: str, namespace: str, expected: str
) -> None:
    assert expand_topic_name(name, "lidar", namespace) == expected


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        (("a b", "node", "/"), InvalidTopicNameError),
        (("a", "no de", "/"), InvalidNodeNameError),
        (("a", "node", "ns"), InvalidNamespaceError),
    ],
)
def test_expand_refuses_invalid_parts(
    arguments: tuple[str, str, str], error: type[InvalidNameError]
) -> None:
    with pytest.raises(error):
        expand_topic_name(*arguments)


def test_expand_points_at_an_unknown_substitution() -> None:
    with pytest.raises(InvalidTopicNameError, match=r"unknown substitution '\{foo\}'") as caught:
        expand_topic_name("a/{foo}/c", "node", "/")
    assert caught.value.invalid_index == 2


@pytest.mark.parametrize(
    ("namespace", "base", "full"),
    [("/", "a", "/a"), ("/ns", "a", "/ns/a"), ("/a/b", "c", "/a/b/c")],
)
def test_namespace_and_base_name_join_and_split(namespace: str, base: str, full: str) -> None:
    assert fully_qualified(namespace, base) == full
    assert split_fully_qualified(full) == (namespace, base)


@pytest.mark.parametrize(
    ("name", "hidden"),
    [
        ("_a", True),
        ("/a/_b", True),
        ("/_x/y", True),
        ("a", False),
        ("/a_", False),
        ("/a/b__c", False),
    ],
)
def test_a_part_with_a_leading_underscore_hides_the_name(name: str, hidden: bool) -> None:
    assert is_hidden(name) is hidden
