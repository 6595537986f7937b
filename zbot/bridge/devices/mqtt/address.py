"""Address of an MQTT broker, with user and certificates."""

from __future__ import annotations

from dataclasses import dataclass
from urllib.parse import unquote, urlsplit

from zbot.bridge.devices.errors import DeviceError

_PORT, _TLS_PORT = 1883, 8883


@dataclass(frozen=True)
class BrokerAddress:
    """Where a broker is, and who connects."""

    host: str = "localhost"
    port: int = _PORT
    user: str = ""
    password: str = ""
    has_tls: bool = False
    ca_file: str = ""  #: certificate of the authority; empty: those of the system
    certificate: str = ""  #: own certificate, for brokers that ask for one
    key: str = ""  #: key of the own certificate

    def __str__(self) -> str:
        return f"{self.host}:{self.port}"


def parse_address(text: str, *, has_tls: bool = False) -> BrokerAddress:
    """Return the address in a text: `broker`, `broker:1883`, `mqtts://ana:secret@broker:8883`.

    Raises:
        DeviceError: The text is not an address.
    """
    try:
        parts = urlsplit(text if "://" in text else f"mqtt://{text}")
        port = parts.port
    except ValueError as error:
        raise DeviceError(f"{text!r} is not the address of a broker: {error}") from None
    if parts.scheme not in {"mqtt", "mqtts"} or not parts.hostname or parts.path.strip("/"):
        raise DeviceError(
            f"{text!r} is not the address of a broker: write HOST, HOST:PORT or mqtts://HOST"
        )
    has_tls = has_tls or parts.scheme == "mqtts"
    return BrokerAddress(
        host=parts.hostname,
        port=port or (_TLS_PORT if has_tls else _PORT),
        user=unquote(parts.username or ""),
        password=unquote(parts.password or ""),
        has_tls=has_tls,
    )
