"""Certificate of the page for https. This machine makes it and renews it.

The folder is a keystore with an authority of its own. A phone that knows the authority's
certificate (`public/ca.cert.pem`) shows no warning.
"""

from __future__ import annotations

import shutil
import ssl
from datetime import datetime, timedelta, timezone
from typing import TYPE_CHECKING

from zbot.classroom.hub.address import own_addresses
from zbot.observer.serving.address import ANY_HOSTS
from zbot.observer.serving.own_names import names_of_machine
from zbot.package.user_folders import settings_folder
from zbot.security.certificate import facts
from zbot.security.errors import SecurityError
from zbot.security.keystore import MACHINE_DAYS, Identity, Keystore, is_keystore
from zbot.security.secret import make_private_folder

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from zbot.security.certificate import Facts

_NAME = "page"
_LEAST_LEFT = timedelta(days=14)
_LOCAL_NAMES = ("localhost", "127.0.0.1", "::1")


class PageCertificate:
    """Certificate of a running page. It is renewed before it expires.

    Args:
        host: The host that the page listens on.
        tell: Called with one line after the renewal, or if it fails.

    Raises:
        SecurityError: The folder of the certificate cannot be written.
    """

    def __init__(self, host: str, tell: Callable[[str], None]) -> None:
        self._host, self._tell = host, tell
        self._is_renewable = True
        self._use()

    @property
    def fingerprint(self) -> str:
        """The fingerprint, as browsers show it: `AB:CD:...`."""
        return fingerprint(self._facts)

    def tls(self) -> ssl.SSLContext:
        """Return the TLS settings of a new connection."""
        if self._is_renewable and not _is_long(self._facts):
            self._renew()
        return self._tls

    def _use(self) -> None:
        identity, self._facts = page_certificate(self._host)
        self._tls = tls_context(identity)

    def _renew(self) -> None:
        try:
            self._use()
        except SecurityError as error:
            self._is_renewable = False
            date = f"{self._facts.until:%Y-%m-%d}"
            self._tell(f"the certificate expires on {date}, and cannot be renewed: {error}")
        else:
            self._tell(f"the certificate was renewed: SHA-256 {self.fingerprint}")


def page_certificate(host: str) -> tuple[Identity, Facts]:
    """Return the files of the page's certificate, and its contents.

    A certificate that misses a present name or address of this machine, or that soon expires, is
    renewed.

    Args:
        host: The host that the page listens on.

    Raises:
        SecurityError: The folder of the certificate cannot be written.
    """
    names = _names(host)
    store = _keystore(settings_folder() / "page-certificate")
    identity = Identity(store.root / "enclaves" / _NAME)
    found = _valid(identity, names)
    if found is None:
        identity = store.issue(_NAME, names, renew=True)
        found = identity.check()
    return identity, found


def fingerprint(found: Facts) -> str:
    """Return the fingerprint of a certificate, as browsers show it: `AB:CD:...`."""
    pairs = (found.fingerprint[at : at + 2] for at in range(0, len(found.fingerprint), 2))
    return ":".join(pairs).upper()


def tls_context(identity: Identity) -> ssl.SSLContext:
    """Return the TLS settings of a server that shows a certificate."""
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.minimum_version = ssl.TLSVersion.TLSv1_2
    context.load_cert_chain(identity.certificate, identity.key)
    context.set_alpn_protocols(["http/1.1"])
    return context


def _names(host: str) -> list[str]:
    """Return the names and addresses at which browsers reach the page."""
    names = [*_LOCAL_NAMES, *own_addresses(), *sorted(names_of_machine())]
    if host not in ANY_HOSTS:
        names.append(host.lower())
    return [name for name in dict.fromkeys(names) if name.isascii() and name]


def _keystore(root: Path) -> Keystore:
    if is_keystore(root) and _is_usable(root / "public" / "ca.cert.pem"):
        return Keystore(root)
    shutil.rmtree(root, ignore_errors=True)
    try:
        make_private_folder(root.parent)
    except OSError as error:
        raise SecurityError(f"cannot use {root.parent}: {error.strerror or error}") from error
    return Keystore.create(root)


def _is_usable(authority: Path) -> bool:
    """Return whether an authority is valid longer than the certificates that it signs."""
    try:
        until = facts(authority).until
    except SecurityError:
        return False
    return until > datetime.now(timezone.utc) + timedelta(days=MACHINE_DAYS)


def _valid(identity: Identity, names: list[str]) -> Facts | None:
    """Return the contents of a certificate, or None if the page needs another one."""
    try:
        found = identity.check()
    except SecurityError:
        return None
    return found if _is_long(found) and set(names) <= set(found.addresses) else None


def _is_long(found: Facts) -> bool:
    """Return whether a certificate is valid for some time."""
    return found.until > datetime.now(timezone.utc) + _LEAST_LEFT
