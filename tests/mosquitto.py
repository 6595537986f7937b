"""MQTT broker of a test: mosquitto of Debian, and a client that is not zbot."""

from __future__ import annotations

import shutil
import socket
import subprocess
from typing import TYPE_CHECKING

import pytest
from paho.mqtt.client import Client
from paho.mqtt.enums import CallbackAPIVersion

from tests.conftest import wait_until

if TYPE_CHECKING:
    from pathlib import Path

    from paho.mqtt.client import MQTTMessage

PROGRAM = shutil.which("mosquitto") or shutil.which("/usr/sbin/mosquitto")
needs_mosquitto = pytest.mark.skipif(
    PROGRAM is None, reason="the broker mosquitto is not here: apt-get install mosquitto"
)


class Mosquitto:
    """A broker that can be stopped and started again on its port.

    Args:
        folder: For its configuration.
        settings: Lines of its configuration.
    """

    def __init__(self, folder: Path, *settings: str) -> None:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port: int = probe.getsockname()[1]
        self._file = folder / "mosquitto.conf"
        # As root, mosquitto would become another user, who cannot read the files of a test.
        lines = [
            "user root",
            f"listener {self.port} 127.0.0.1",
            *(settings or ("allow_anonymous true",)),
        ]
        self._file.write_text("\n".join(lines))
        self.start()

    @property
    def address(self) -> str:
        return f"127.0.0.1:{self.port}"

    def start(self) -> None:
        assert PROGRAM is not None
        command = [PROGRAM, "-c", str(self._file)]
        self._process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
        if not wait_until(self._listens):
            self.stop()
            pytest.fail("mosquitto does not listen")

    def _listens(self) -> bool:
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0

    def stop(self) -> None:
        self._process.terminate()
        self._process.wait(10)


class Thing:
    """A client of a broker, e.g. a lamp.

    Args:
        port: Port of the broker.
        filters: The topics to hear.
    """

    def __init__(self, port: int, *filters: str, user: str = "", password: str = "") -> None:
        self.heard: list[tuple[str, str, bool]] = []
        self._subscribed = False
        self._client = Client(CallbackAPIVersion.VERSION2)
        if user:
            self._client.username_pw_set(user, password)
        self._client.on_message = self._on_message
        self._client.on_subscribe = lambda *_: setattr(self, "_subscribed", True)
        self._client.connect("127.0.0.1", port)
        self._client.loop_start()
        if filters:
            self._client.subscribe([(text, 0) for text in filters])
            assert wait_until(lambda: self._subscribed)

    def _on_message(self, _client: object, _data: object, message: MQTTMessage) -> None:
        self.heard.append((message.topic, message.payload.decode(), message.retain))

    def publish(self, topic: str, payload: str, *, is_retained: bool = False) -> None:
        self._client.publish(topic, payload, 0, is_retained)

    def close(self) -> None:
        self._client.disconnect()
        self._client.loop_stop()
