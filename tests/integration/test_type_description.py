"""Tests of type descriptions that nodes send and other nodes use."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.graph.endpoint_info import TypeHash
from zbot.interfaces import MessageSpec, get_message, get_spec, type_hash
from zbot.interfaces.errors import DefinitionLimitError
from zbot.interfaces.parser import parse
from zbot.interfaces.remote_definition import hash_among, specs_from_sources
from zbot.node.service_types import DESCRIPTION_SERVICE
from zbot.remote.types import learn_type
from zbot.wire.tokens import EntityKind

from type_description_interfaces.msg import TypeSource
from type_description_interfaces.srv import GetTypeDescription

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from tests.conftest import MakeContext, Spin, Start

Request = GetTypeDescription.Request
OFF = zbot.Parameter("start_type_description_service", value=False)


@pytest.fixture
def describe(make_context: MakeContext) -> Callable[..., Any]:
    """Client of the type-description service of a node that does not spin."""
    zbot.Node("robot", namespace="lab", context=make_context())
    asking = zbot.Node("asking", context=make_context())
    client = asking.create_client(GetTypeDescription, "/lab/robot/get_type_description")
    assert client.wait_for_service(5)

    def ask(**fields: Any) -> Any:
        return client.call(Request(**fields), 5)

    return ask


def test_a_description_includes_nested_types(describe: Callable[..., Any]) -> None:
    response = describe(type_name="std_msgs/msg/Header", type_hash=type_hash("std_msgs/Header"))
    assert response.successful
    described = response.type_description
    assert described.type_description.type_name == "std_msgs/msg/Header"
    stamp, frame = described.type_description.fields
    assert (stamp.type.type_id, stamp.type.nested_type_name) == (1, "builtin_interfaces/msg/Time")
    assert (frame.name, frame.type.type_id) == ("frame_id", 17)
    inner = [description.type_name for description in described.referenced_type_descriptions]
    assert inner == ["builtin_interfaces/msg/Time"]
    texts = {
        source.type_name: (source.encoding, source.raw_file_contents)
        for source in response.type_sources
    }
    assert texts == {
        "std_msgs/msg/Header": ("msg", get_spec("std_msgs/msg/Header").text),
        "builtin_interfaces/msg/Time": ("msg", get_spec("builtin_interfaces/msg/Time").text),
    }


def test_a_request_takes_the_hash_that_the_graph_shows(describe: Callable[..., Any]) -> None:
    shown: Any = TypeHash.parse(type_hash("std_msgs/Header"))
    assert Request(type_hash=shown).type_hash == type_hash("std_msgs/Header")
    assert describe(type_name="std_msgs/msg/Header", type_hash=shown).successful


def test_request_and_response_have_their_services_source(describe: Callable[..., Any]) -> None:
    response = describe(type_name="std_srvs/srv/Trigger")
    texts = {
        source.type_name: (source.encoding, source.raw_file_contents)
        for source in response.type_sources
    }
    assert texts["std_srvs/srv/Trigger"] == ("srv", get_spec("std_srvs/srv/Trigger").text)
    assert texts["std_srvs/srv/Trigger_Event"] == ("implicit", "")


def test_sources_and_default_values_are_described(describe: Callable[..., Any]) -> None:
    name = "type_description_interfaces/srv/GetTypeDescription_Request"
    response = describe(type_name=name, include_type_sources=False)
    assert response.type_sources == []
    fields = response.type_description.type_description.fields
    assert [field.default_value for field in fields] == ["", "", "True"]


def test_a_refusal_has_its_reason(describe: Callable[..., Any]) -> None:
    response = describe(type_name="std_srvs/srv/Trigr")
    assert not response.successful
    assert "did you mean 'std_srvs/srv/Trigger'?" in response.failure_reason
    response = describe(type_name="std_srvs/srv/Trigger", type_hash="RIHS01_0")
    assert not response.successful
    assert response.failure_reason.endswith("not RIHS01_0")


def test_the_service_carries_the_hash_of_its_type() -> None:
    assert type_hash(GetTypeDescription) == DESCRIPTION_SERVICE[1]


def test_the_service_can_be_switched_off_by_a_parameter(make_context: MakeContext) -> None:
    node = zbot.Node("quiet", context=make_context(), parameter_overrides=[OFF])
    assert "/quiet/get_type_description" not in [service.service_name for service in node.services]


# -- types that only another process has -----------------------------------------------------------


def test_an_unused_type_is_not_described(make_context: MakeContext) -> None:
    zbot.Node("robot", context=make_context())
    assert learn_type(make_context(), "my_robot/msg/Unheard") is None


def services_of(context: zbot.Context) -> set[str]:
    return {name for name, _ in context.graph.snapshot().services()}


@contextmanager
def teller(
    make_context: MakeContext, spin: Spin, name: str, texts: dict[str, str], type_hash: str
) -> Iterator[zbot.Context]:
    """Run a node that publishes a type with a hash and describes it by texts."""
    node = zbot.Node("teller", context=make_context(), parameter_overrides=[OFF])

    def describe(_: Any, response: Any) -> Any:
        response.successful = True
        response.type_sources = [
            TypeSource(type_name=type_name, encoding="msg", raw_file_contents=text)
            for type_name, text in texts.items()
        ]
        return response

    token = node.handle.named_endpoint(
        EntityKind.PUBLISHER, "/text", (name, type_hash), zbot.QoSProfile(depth=1)
    )
    announcement = node.context.graph.announce(token)
    node.create_service(GetTypeDescription, "~/get_type_description", describe)
    spin(node)
    context = make_context()
    assert wait_until(
        lambda: (
            bool(context.graph.snapshot().publishers("/text"))
            and "/teller/get_type_description" in services_of(context)
        )
    )
    yield context
    announcement.undeclare()


@pytest.mark.parametrize(
    ("text", "is_believed"), [("int32 truth\n", False), ("int64 truth\n", True), ("int32", False)]
)
def test_a_description_with_another_hash_is_rejected(
    make_context: MakeContext, spin: Spin, text: str, is_believed: bool
) -> None:
    name = f"liars/msg/Text{len(text)}{is_believed}"
    spec = parse(name, "int64 truth\n")
    with teller(make_context, spin, name, {name: text}, hash_among(name, [spec])) as context:
        assert learn_type(context, name) == (spec if is_believed else None)


def test_a_definition_that_would_fill_the_memory_is_refused(
    make_context: MakeContext, spin: Spin
) -> None:
    name = "evil_msgs/msg/Bomb"
    texts = {f"evil_msgs/msg/A{i}": f"A{i + 1} a\nA{i + 1} b\n" for i in range(29)}
    texts |= {"evil_msgs/msg/A29": "int32 x\n", name: "A0 a\nA0 b\n"}
    type_hash = hash_among(name, specs_from_sources(name, texts))
    with (
        teller(make_context, spin, name, texts, type_hash) as context,
        pytest.raises(DefinitionLimitError, match=f"^{name}: zbot does not use this definition"),
    ):
        learn_type(context, name)
    with pytest.raises(LookupError):
        get_message(name)


PROGRAM = """
import dataclasses, threading, zbot
@dataclasses.dataclass
class Wheel:
    radius: float = 0.1
    spokes: list[int] = dataclasses.field(default_factory=list)
@dataclasses.dataclass
class Cart:
    name: str = "cart"
    wheels: list[Wheel] = dataclasses.field(default_factory=list)
zbot.init()
node = zbot.Node("cart")
node.create_publisher(Cart, "cart", 10)
print("ready", flush=True)
threading.Event().wait()
"""


def test_a_dataclass_of_another_process_can_be_used(
    make_context: MakeContext, start: Start, tmp_path: Path
) -> None:
    start(source=PROGRAM).wait_for("ready")
    (path,) = tmp_path.glob("program_*.py")
    context = make_context()
    spec = learn_type(context, f"{path.stem}/msg/Cart")
    assert isinstance(spec, MessageSpec)
    assert [(field.name, str(field.type)) for field in spec.fields] == [
        ("name", "string"),
        ("wheels", f"sequence<{path.stem}/Wheel>"),
    ]
    assert get_message(f"{path.stem}/msg/Wheel")(radius=0.5, spokes=[1, 2])
