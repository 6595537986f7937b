"""Connection to an MQTT broker, which is opened again whenever it is lost."""

from __future__ import annotations

import ssl
import threading
from typing import TYPE_CHECKING, Any, Protocol

from zbot.bridge.devices.errors import DeviceError
from zbot.errors import MissingPackageError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.bridge.devices.mqtt.address import BrokerAddress
    from zbot.log import Logger

_FIRST_ANSWER_S = 10.0
_KEEP_ALIVE_S = 30
_RECONNECT_S = (1, 5)
_WAITING_MESSAGES = 10_000
_UNSENT_MESSAGES = 1_000  #: that the broker has not confirmed
#: Reasons for which a broker refuses a user. They do not change by waiting.
_REFUSED = frozenset(("Bad user name or password", "Not authorized"))
_OLD_BROKER = "Unsupported protocol version"


class Heard(Protocol):
    """A message of the broker, as paho-mqtt gives it."""

    topic: str
    payload: bytes
    retain: bool


def mqtt_library() -> Any:
    """Return paho-mqtt's module `client`.

    Raises:
        MissingPackageError: paho-mqtt is not installed.
    """
    try:
        from paho.mqtt import client  # noqa: PLC0415 - an extra
    except ImportError:
        raise MissingPackageError("zbot mqtt", "paho-mqtt", "mqtt") from None
    return client


class BrokerClient:
    """Client of a broker. paho-mqtt's thread calls the functions.

    Args:
        address: The broker.
        log: Where to log that the connection was lost and is back.
        filters: MQTT filters of the topics to get, e.g. `home/#`.
        heard: Called with each message.

    Raises:
        MissingPackageError: paho-mqtt is not installed.
        DeviceError: A certificate cannot be read, or the broker cannot be reached or refuses.
    """

    def __init__(
        self,
        address: BrokerAddress,
        log: Logger,
        filters: Sequence[str],
        heard: Callable[[Heard], object],
    ) -> None:
        self._address, self._log, self._filters, self._heard = address, log, filters, heard
        self._mqtt = mqtt_library()
        self._answered = threading.Event()
        self._refusal: str | None = None
        self._is_connected = False
        self._client = self._started(5)

    def publish(self, topic: str, payload: bytes, qos: int, *, is_retained: bool) -> bool:
        """Send a message. Return whether it was sent or waits for the broker."""
        info = self._client.publish(topic, payload, qos, is_retained)
        code = info.rc
        waits = qos > 0 and code == self._mqtt.MQTT_ERR_NO_CONN
        return code == self._mqtt.MQTT_ERR_SUCCESS or waits

    def close(self) -> None:
        """Send what waits, and leave the broker."""
        self._client.disconnect()
        self._client.loop_stop()

    # -- connecting ----------------------------------------------------------------------------

    def _started(self, version: int) -> Any:
        """Return a client that has an answer of the broker, in a version of MQTT."""
        self._answered.clear()
        self._refusal = None
        client = self._new(version)
        try:
            client.connect(self._address.host, self._address.port, _KEEP_ALIVE_S)
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            raise DeviceError(
                f"no MQTT broker answers on {self._address}: {reason}",
                hint="is its address right, and does it run there?",
            ) from error
        client.loop_start()
        if not self._answered.wait(_FIRST_ANSWER_S):
            self._refusal = f"no answer within {_FIRST_ANSWER_S:.0f} s"
        refusal = self._refusal
        if refusal is None:
            return client
        client.disconnect()
        client.loop_stop()
        if refusal == self._refusal_text(_OLD_BROKER) and version == 5:
            return self._started(4)  # MQTT 3.1.1
        raise DeviceError(f"{self._address}: {refusal}")

    def _refusal_text(self, reason: str) -> str:
        if reason not in _REFUSED:
            return f"the broker refuses: {reason}"
        user = self._address.user
        if user:
            return f"the broker refuses {user}: is the password in ZBOT_MQTT_PASSWORD right?"
        return "the broker asks for a user and a password: use --user, and ZBOT_MQTT_PASSWORD"

    def _new(self, version: int) -> Any:
        mqtt, address = self._mqtt, self._address
        client = mqtt.Client(
            mqtt.CallbackAPIVersion.VERSION2, protocol=mqtt.MQTTProtocolVersion(version)
        )
        if address.user:
            client.username_pw_set(address.user, address.password or None)
        if address.has_tls:
            client.tls_set_context(_tls_context(address))
        client.reconnect_delay_set(*_RECONNECT_S)
        client.max_queued_messages_set(_WAITING_MESSAGES)
        client.max_inflight_messages_set(_UNSENT_MESSAGES)
        client.on_connect, client.on_disconnect = self._on_connect, self._on_disconnect
        client.on_subscribe, client.on_message = self._on_subscribe, self._on_message
        return client

    def _on_connect(self, client: Any, _data: Any, _flags: Any, code: Any, _more: Any) -> None:
        if code.is_failure:
            self._refuse(self._refusal_text(str(code)))
            return
        self._is_connected = True
        if self._filters:
            client.subscribe([(text, self._options(client)) for text in self._filters])
        else:
            self._be_ready()

    def _on_subscribe(self, _client: Any, _data: Any, _id: int, codes: Any, _more: Any) -> None:
        """Read the answers of the broker, one for each filter."""
        answers = zip(self._filters, codes, strict=False)
        refused = [f"{text} ({code})" for text, code in answers if code.is_failure]
        if refused:
            self._refuse(f"the broker refuses {', '.join(refused)}")
        else:
            self._be_ready()

    def _be_ready(self) -> None:
        """Say that the broker is back. From now on, no message of it is missed."""
        if self._answered.is_set():
            self._log.info(f"the broker {self._address} is back")
        self._refusal = None
        self._answered.set()

    def _refuse(self, text: str) -> None:
        """End the wait for the first answer. Log a later refusal, but not again at each try."""
        if self._answered.is_set() and text != self._refusal:
            self._log.warning(f"{self._address}: {text}")
        self._refusal = text
        self._answered.set()

    def _options(self, client: Any) -> Any:
        """Return the options of a subscription.

        The quality is 0: a broker such as mosquitto loses messages of a higher one if they come
        fast, and keeps none for a client that was away.
        """
        if int(client.protocol) != 5:
            return 0
        from paho.mqtt.subscribeoptions import SubscribeOptions  # noqa: PLC0415 - an extra

        return SubscribeOptions(qos=0, noLocal=True, retainAsPublished=True)

    def _on_message(self, _client: Any, _data: Any, message: Heard) -> None:
        try:
            self._heard(message)
        except Exception as error:  # noqa: BLE001 - it would end paho-mqtt's thread
            self._log.error(f"{message.topic}: {error}")

    def _on_disconnect(self, _client: Any, _data: Any, _flags: Any, code: Any, _more: Any) -> None:
        if self._is_connected and code.is_failure:
            self._refusal = None
            self._log.warning(f"the broker {self._address} is gone: waiting until it is back")
        self._is_connected = False


def _tls_context(address: BrokerAddress) -> ssl.SSLContext:
    try:
        context = ssl.create_default_context(cafile=address.ca_file or None)
        if address.certificate:
            context.load_cert_chain(address.certificate, address.key or None)
    except OSError as error:  # also the errors of ssl
        raise DeviceError(f"cannot read the certificates: {error}") from error
    return context
