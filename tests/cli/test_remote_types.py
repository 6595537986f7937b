"""Tests of commands with types that only the workspace of another process defines."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from tests.conftest import wait_until
from zbot.bag import Reader

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Program, Start

FILES = {
    "package.xml": "<package><name>far_robot</name></package>",
    "msg/Heat.msg": "# How warm.\nuint8 HOT=3\nfloat32 value # degrees\nPart[] parts\n",
    "msg/Part.msg": 'string name "arm" # which\n',
    "srv/Warm.srv": "int64 seconds\n---\nbool done\nPart part\n",
    "action/Boil.action": "int32 order\n---\nPart part\n---\nfloat32 left\n",
}
ROBOT = """
import zbot
from zbot.action import ActionServer
from far_robot.action import Boil
from far_robot.msg import Heat, Part
from far_robot.srv import Warm

zbot.init()
node = zbot.Node("robot")
publisher = node.create_publisher(Heat, "heat", 10)
node.create_timer(0.1, lambda: publisher.publish(Heat(value=3.5, parts=[Part()])))
node.create_subscription(Heat, "wanted", lambda msg: print("heard", msg, flush=True), 10)

def warm(request, response):
    response.part.name = str(request.seconds)
    return response

def boil(goal_handle):
    goal_handle.succeed()
    return Boil.Result(part=Part(name=str(goal_handle.request.order)))

node.create_service(Warm, "warm", warm)
server = ActionServer(node, Boil, "boil", boil)
print("ready", flush=True)
zbot.spin(node)
"""


@pytest.fixture
def robot(start: Start, tmp_path_factory: pytest.TempPathFactory) -> Program:
    """Start a process with a workspace that other processes cannot read."""
    package: Path = tmp_path_factory.mktemp("far") / "far_robot"
    for name, text in FILES.items():
        path = package / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    program = start(source=ROBOT, env={"ZBOT_WORKSPACE": str(package.parent)})
    program.wait_for("ready")
    return program


@pytest.mark.parametrize(
    ("word", "text"),
    [
        ("far_robot/msg/Heat", f'{FILES["msg/Heat.msg"]}\tstring name "arm"\n'),
        ("far_robot/Part", FILES["msg/Part.msg"]),
        ("Warm", f'{FILES["srv/Warm.srv"]}\tstring name "arm"\n'),
        ("Boil", 'int32 order\n---\nPart part\n\tstring name "arm"\n---\nfloat32 left\n'),
    ],
)
@pytest.mark.usefixtures("robot")
def test_interface_show(word: str, text: str) -> None:
    done = zbot("interface", "show", word)
    assert (done.code, done.out, done.err) == (0, text, "")


@pytest.mark.usefixtures("robot")
def test_topic_echo() -> None:
    done = zbot("topic", "echo", "heat", "--once")
    assert (done.code, done.out) == (0, "value: 3.5\nparts:\n- name: arm\n---\n")
    assert zbot("topic", "echo", "heat", "far_robot/Heat", "--once", "--csv").out == "3.5,arm\n"


def test_topic_pub(robot: Program) -> None:
    done = zbot("topic", "pub", "--once", "wanted", "far_robot/msg/Heat", "{value: 2}")
    assert (done.code, done.err) == (0, "")
    robot.wait_for("heard far_robot.msg.Heat(value=2.0, parts=[])")
    assert zbot("topic", "pub", "--once", "wanted", "value=4").code == 0
    robot.wait_for("heard far_robot.msg.Heat(value=4.0, parts=[])")


@pytest.mark.parametrize("words", [[], ["far_robot/srv/Warm"]])
@pytest.mark.usefixtures("robot")
def test_service_call(words: list[str]) -> None:
    done = zbot("service", "call", "warm", *words, "{seconds: 7}")
    assert done.out.endswith(
        "response:\nfar_robot.srv.Warm_Response(done=False, part=far_robot.msg.Part(name='7'))\n\n"
    )


@pytest.mark.parametrize("words", [[], ["far_robot/action/Boil"]])
@pytest.mark.usefixtures("robot")
def test_action_send_goal(words: list[str]) -> None:
    done = zbot("action", "send_goal", "boil", *words, "{order: 5}")
    assert (done.code, done.err) == (0, "")
    assert "name: '5'" in done.out


@pytest.mark.usefixtures("domain")
def test_a_type_that_no_process_has_is_unknown() -> None:
    assert zbot("interface", "show", "far_robot/msg/Heat").code == 1
    assert zbot("topic", "echo", "heat", "far_robot/msg/Heat").err.startswith(
        "The passed message type is invalid\n"
    )


@pytest.mark.usefixtures("robot")
def test_bag_record(start: Start, tmp_path: Path) -> None:
    program = start("zbot", "bag", "record", "-o", "lesson", "/heat")
    program.wait_for("Subscribed to topic '/heat'")
    file = tmp_path / "lesson" / "lesson_0.mcap"
    assert wait_until(lambda: file.exists() and file.stat().st_size > 1000)
    assert program.stop() == 0
    with Reader(tmp_path / "lesson") as bag:
        assert bag.definition("far_robot/msg/Heat").text.startswith(FILES["msg/Heat.msg"])
        assert bag.metadata.message_count > 0
