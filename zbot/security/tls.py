"""TLS between hubs: Zenoh's settings, and checks that explain why a link fails."""

from __future__ import annotations

import ipaddress
import socket
import ssl
import time
from typing import TYPE_CHECKING, Any

from zbot.security.certificate import Facts, check_issued
from zbot.security.errors import (
    certificate_address_error,
    no_tls_error,
    refused_certificate_error,
    silent_tls_error,
)

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.security.keystore import Identity


_HANDSHAKE_S = 3.0  #: long enough for TCP to repeat lost packets
# In TLS 1.3, a server refuses a client's certificate after the handshake, one round trip later.
_REFUSAL_S = 0.4
_CLOSED_S = 2.5  # a hub closes a connection after 3 s if Zenoh's first message does not come


def tls_settings(identity: Identity) -> dict[str, Any]:
    """Return Zenoh's configuration paths and values for a hub with a keystore.

    Both sides show a certificate of the same authority. A hub's certificate must be a server's
    certificate, and must contain the address to which the other side connects. A link ends when a
    certificate expires. The settings apply to endpoints that begin with `tls/`, not to `tcp/`
    (loopback).
    """
    values = {
        "root_ca_certificate": str(identity.authority),
        "listen_certificate": str(identity.certificate),
        "listen_private_key": str(identity.key),
        "connect_certificate": str(identity.certificate),
        "connect_private_key": str(identity.key),
        "enable_mtls": True,
        "verify_name_on_connect": True,
        "close_link_on_expiration": True,
    }
    return {f"transport/link/tls/{name}": value for name, value in values.items()}


def check_listening(identity: Identity, address: str) -> Facts:
    """Check that a machine's certificate lets other machines join the machine.

    Args:
        identity: The machine's key and certificates.
        address: The address at which others reach the machine. A certificate that contains a host
            name is accepted for any address, because others may use the host name.

    Raises:
        SecurityError: The certificate is not valid (see `certificate.check`). Or it is a
            client's certificate, or a certificate for other addresses.
    """
    said = identity.check()
    if not said.is_server:
        raise certificate_address_error(identity.certificate, said.name, address, ())
    if all(_is_ip(known) for known in said.addresses):
        _check_address(identity.certificate, said, address)
    return said


def check_dialling(
    identity: Identity, host: str, port: int, timeout_s: float = _HANDSHAKE_S
) -> Facts:
    """Check both certificates in a TLS handshake with a hub.

    This function reports which certificate is wrong, and why, because Zenoh does not report this.
    It sends only the handshake.

    Args:
        identity: This machine's key and certificates.
        host: The hub's host, as in the endpoint to which Zenoh will connect.
        port: The hub's port.
        timeout_s: Seconds for each step of the handshake.

    Returns:
        The contents of the hub's certificate.

    Raises:
        SecurityError: This machine's certificate or the hub's is invalid, or the hub does not
            accept this machine's certificate, or the program at the address does not use TLS.
        OSError: No program answers.
    """
    identity.check()
    with socket.create_connection((host, port), timeout_s) as plain:
        begun = time.monotonic()
        try:
            with _context(identity).wrap_socket(plain, server_hostname=host) as wrapped:
                shown = wrapped.getpeercert(binary_form=True)
                said = _checked_server(shown or b"", identity, host, port)
                took_s = time.monotonic() - begun
                wait_s = min(max(_REFUSAL_S, 2 * took_s), _CLOSED_S - took_s)
                _await_refusal(wrapped, host, port, max(wait_s, 0.01))
                return said
        except ssl.SSLError as exc:
            if "ALERT" in (exc.reason or ""):
                raise refused_certificate_error(host, port, _in_words(exc)) from exc
            raise no_tls_error(host, port) from exc
        except TimeoutError as exc:
            raise silent_tls_error(host, port) from exc
        except ConnectionError as exc:
            raise no_tls_error(host, port) from exc


def _context(identity: Identity) -> ssl.SSLContext:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    # OpenSSL does not check the hub's certificate here. `_checked_server` does, because its errors
    # are clearer. Later, Zenoh checks the certificate again.
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    context.load_cert_chain(identity.certificate, identity.key)
    return context


def _checked_server(shown: bytes, identity: Identity, host: str, port: int) -> Facts:
    said = check_issued(shown, f"{host}:{port}", identity.authority)
    if not said.is_server:
        raise certificate_address_error(f"{host}:{port}", said.name, host, ())
    _check_address(f"{host}:{port}", said, host)
    return said


def _await_refusal(wrapped: ssl.SSLSocket, host: str, port: int, timeout_s: float) -> None:
    wrapped.settimeout(timeout_s)
    try:
        if not wrapped.recv(1):
            raise refused_certificate_error(host, port, "it closed the connection")
    except TimeoutError:
        return  # the hub waits for Zenoh's first message, so it has accepted the certificate


def _check_address(path: Path | str, said: Facts, address: str) -> None:
    if not any(_same(known, address) for known in said.addresses):
        raise certificate_address_error(path, said.name, address, said.addresses)


def _is_ip(address: str) -> bool:
    try:
        ipaddress.ip_address(address)
    except ValueError:
        return False
    return True


def _same(known: str, address: str) -> bool:
    try:
        return ipaddress.ip_address(known) == ipaddress.ip_address(address)
    except ValueError:
        return known.lower() == address.lower()


def _in_words(error: ssl.SSLError) -> str:
    return (error.reason or "").lower().rpartition("alert_")[2].replace("_", " ")
