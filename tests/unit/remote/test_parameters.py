"""Client of other nodes' parameters: what it makes of the nodes' answers."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from tests.unit.remote.fake_calls import FakeCalls, FakeNode
from zbot.errors import WrongValueError
from zbot.parameters.parameter import Parameter, UnknownParameterTypeError
from zbot.remote.parameters import ParameterNotSetError, RemoteParameters
from zbot.remote.service_calls import NoServiceError

from rcl_interfaces.msg import ParameterDescriptor, ParameterValue


def remote(node: object) -> RemoteParameters:
    return RemoteParameters(FakeCalls(robot=node))


def answering(**fields: Any) -> object:
    """Return a node that has the parameter `a`, and whose other answers are wrong."""
    wrong = SimpleNamespace(**fields)
    names = SimpleNamespace(result=SimpleNamespace(names=["a"]))
    return SimpleNamespace(
        list_parameters=lambda _: names,
        get_parameters=lambda _: wrong,
        describe_parameters=lambda _: wrong,
        set_parameters=lambda _: wrong,
    )


def test_names_are_sorted_and_values_come_by_name() -> None:
    client = remote(FakeNode(rate=5, name="a"))
    assert client.names("/robot") == ["name", "rate"]
    values = client.values("/robot", ["rate", "name"])
    assert {name: value.value for name, value in values.items()} == {"rate": 5, "name": "a"}


def test_a_parameter_that_the_node_lacks_is_named() -> None:
    client = remote(FakeNode(rate=5))
    for ask in (client.values, client.descriptors):
        with pytest.raises(ParameterNotSetError) as caught:
            ask("/robot", ["rate", "rote"])
        assert caught.value.hint == "/robot has no parameter rote; did you mean 'rate'?"
    assert client.value("/robot", "rote").value is None
    assert list(client.known_values("/robot", ["rate", "rote"])) == ["rate"]


def test_several_nodes_answer_or_have_an_error() -> None:
    client = RemoteParameters(FakeCalls(robot=FakeNode(b=1, a=2), arm=FakeNode()))
    answers = client.all_names(["/robot", "/arm", "/gone"])
    assert answers.found == {"/robot": ["a", "b"], "/arm": []}
    assert isinstance(answers.errors["/gone"], NoServiceError)


def test_an_answer_that_does_not_fit_is_refused() -> None:
    many = [ParameterDescriptor(name="a")] * 2
    with pytest.raises(WrongValueError, match="/robot gave a wrong answer"):
        remote(answering(descriptors=many)).descriptors("/robot", ["a"])
    with pytest.raises(WrongValueError):
        remote(answering(results=[])).set("/robot", [Parameter("a", value=1)])
    with pytest.raises(UnknownParameterTypeError):
        remote(answering(values=[ParameterValue(type=99)])).values("/robot", ["a"])


@pytest.mark.parametrize(
    ("present", "given", "sent"),
    [(2.0, 3, 3.0), (2, 3.0, 3), (2, 3.5, 3.5), ("a", 3, 3), (True, 1, 1), (2.0, True, True)],
)
def test_a_number_of_json_gets_the_type_of_the_nodes_number(
    present: object, given: object, sent: object
) -> None:
    value = remote(FakeNode(a=present)).from_json("/robot", "a", given).value
    assert (value, type(value)) == (sent, type(sent))


def test_a_list_of_a_file_becomes_bytes_if_the_nodes_value_is_bytes() -> None:
    client = remote(FakeNode(key=[b"\x01"], sizes=[1]))
    made = client.from_file("/robot", {"key": [1, 2], "sizes": [1, 2], "new": [3]})
    assert [parameter.value for parameter in made] == [[b"\x01", b"\x02"], [1, 2], [3]]
