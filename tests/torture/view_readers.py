"""Readers of the 3D view: the requests of browsers, and the messages that displays draw."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tests.torture.reader import Reader
from tests.unit.view.messages import MESSAGES
from zbot.libraries.robot_description.mesh_address import path_of
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.observer.serving.request import RequestError, parsed
from zbot.view.arrangement.errors import ArrangementError
from zbot.view.arrangement.link import link_text, read_link
from zbot.view.arrangement.rviz_file import read_rviz
from zbot.view.arrangement.rviz_writer import rviz_text
from zbot.view.displays import DISPLAYS
from zbot.view.errors import DisplayError
from zbot.view.server.guard import Guard, passed_on
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.codec import messagepack_codec_for

from sensor_msgs.msg import CameraInfo

_RVIZ_FILE = Path(__file__).parents[1] / "unit/view/arrangement/example.rviz"
_SHOWN = [display for display in DISPLAYS if display.name in MESSAGES]
_SAMPLES = [MESSAGES[display.name] for display in _SHOWN]


def _codec(number: int) -> Any:
    return messagepack_codec_for(type(_SAMPLES[number]))


def _view_message(data: bytes) -> None:
    """Draw a message. The first byte says which display."""
    number = data[0] % len(_SHOWN) if data else 0
    display = _SHOWN[number]("/topic")
    if display.name == "Image":
        display.take(CameraInfo(height=200, k=[100.0, 0, 0, 0, 100.0, 0, 0, 0, 1]))
    message = _codec(number).decode(data[1:])
    for name in display.values:
        choices = next(setting.choices for setting in display.settings if setting.name == name)
        for choice in choices or (display.values[name],):
            display.values[name] = choice
            display.take(message)
    display.tick(0)


def _view_request(data: bytes) -> None:
    request = parsed(data)
    Guard("127.0.0.1", 1, "a").answer(request)
    passed_on(request)


def _rviz_file(data: bytes) -> None:
    """Read a file of rviz, and write it again."""
    rviz_text(read_rviz(data.decode(errors="replace")))


def _link(data: bytes) -> None:
    read_link(data.decode(errors="replace"))


VIEW_READERS = (
    Reader(
        "view_link",
        ("zbot.view.arrangement.link",),
        _link,
        (ArrangementError,),
        (link_text(read_rviz(_RVIZ_FILE.read_text(encoding="utf-8"))).encode(),),
    ),
    Reader(
        "rviz_file",
        ("zbot.view.arrangement.rviz_file",),
        _rviz_file,
        (ArrangementError,),
        (_RVIZ_FILE.read_bytes(),),
    ),
    Reader(
        "view_message",
        ("zbot.view.displays.display",),
        _view_message,
        (DisplayError, CodecError),
        tuple(
            bytes([place]) + _codec(place).encode(sample) for place, sample in enumerate(_SAMPLES)
        ),
    ),
    Reader(
        "mesh_address",
        ("zbot.libraries.robot_description.mesh_address",),
        lambda data: path_of(data.decode(errors="replace")),
        (DescriptionError,),
        (b"package://zbot_nodes/meshes/a%20b.stl", b"file:///a.stl", b"a/b.stl"),
    ),
    Reader(
        "view_request",
        ("zbot.observer.serving.request", "zbot.view.server.guard"),
        _view_request,
        (RequestError,),
        (b"GET /?token=a HTTP/1.1\r\nHost: a:1\r\nUpgrade: websocket\r\nCookie: b=c\r\n\r\n",),
    ),
)
