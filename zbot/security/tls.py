"""TLS between hubs: what Zenoh has to be told, and why two machines do not get together."""

from __future__ import annotations

import ipaddress
import socket
import ssl
from typing import TYPE_CHECKING, Any

from zbot.security.certificate import Facts, check_issued
from zbot.security.errors import (
    NoServerCertificateError,
    NoTlsError,
    RefusedCertificateError,
    WrongAddressError,
)

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.security.keystore import Identity

PROTOCOL = "tls"  #: of endpoints between hubs with a keystore, in the place of `tcp`

_HANDSHAKE_S = 1.5  #: so that a sentence comes within two seconds
#: A refusal of our certificate follows the handshake (TLS 1.3) at the distance of one round trip.
_REFUSAL_S = 0.4


def tls_settings(identity: Identity) -> dict[str, Any]:
    """Return Zenoh's configuration paths and values for a hub with a keystore.

    Both sides show a certificate of the same authority; a hub's has to be a server's and name the
    address that was dialled. A link ends when a certificate expires. This holds for endpoints that
    begin with `tls/`; those with `tcp/` (loopback) stay as they are.
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
    """Check that a machine's certificate lets others join it.

    Args:
        identity: The machine's.
        address: Where others reach it. A certificate with a host's name will do as well, as they
            may use that.

    Raises:
        CertificateError: It is missing, damaged, expired, foreign, only a client's, or for other
            addresses.
    """
    said = identity.check()
    if not said.is_server:
        raise NoServerCertificateError(identity.certificate, said.name)
    if all(_is_ip(known) for known in said.addresses):
        _check_address(identity.certificate, said, address)
    return said


def check_dialling(
    identity: Identity, host: str, port: int, timeout_s: float = _HANDSHAKE_S
) -> Facts:
    """Shake hands with a hub, to say what Zenoh does not: whose certificate is wrong, and how.

    Nothing is sent but the handshake.

    Args:
        identity: This machine's.
        host: As it will be dialled.
        port: There.
        timeout_s: For each step of the handshake.

    Returns:
        What the hub's certificate says.

    Raises:
        CertificateError: This machine's certificate or the hub's is of no use.
        RefusedCertificateError: The hub does not accept this machine's.
        NoTlsError: No hub with a keystore answers there.
        OSError: Nobody answers at all.
    """
    identity.check()
    with socket.create_connection((host, port), timeout_s) as plain:
        try:
            with _context(identity).wrap_socket(plain, server_hostname=host) as wrapped:
                shown = wrapped.getpeercert(binary_form=True)
                said = _checked_server(shown or b"", identity, host, port)
                _await_refusal(wrapped, host, port)
                return said
        except ssl.SSLError as exc:
            if "ALERT" in (exc.reason or ""):
                raise RefusedCertificateError(host, port, _in_words(exc)) from exc
            raise NoTlsError(host, port) from exc
        except (TimeoutError, ConnectionError) as exc:
            raise NoTlsError(host, port) from exc


def _context(identity: Identity) -> ssl.SSLContext:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    # Looked at below instead, in more words than OpenSSL has; Zenoh's own handshake verifies again.
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    context.load_cert_chain(identity.certificate, identity.key)
    return context


def _checked_server(shown: bytes, identity: Identity, host: str, port: int) -> Facts:
    said = check_issued(shown, f"{host}:{port}", identity.authority)
    if not said.is_server:
        raise NoServerCertificateError(f"{host}:{port}", said.name)
    _check_address(f"{host}:{port}", said, host)
    return said


def _await_refusal(wrapped: ssl.SSLSocket, host: str, port: int) -> None:
    wrapped.settimeout(_REFUSAL_S)
    try:
        if not wrapped.recv(1):
            raise RefusedCertificateError(host, port, "it hung up")
    except TimeoutError:
        return  # it waits for Zenoh's first message: we are in


def _check_address(path: Path | str, said: Facts, address: str) -> None:
    if not any(_same(known, address) for known in said.addresses):
        raise WrongAddressError(path, said.name, address, list(said.addresses))


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
