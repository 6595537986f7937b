"""Tests of the certificate of the page for https."""

from __future__ import annotations

import hashlib
import os
import ssl
import stat
from datetime import datetime, timedelta, timezone
from typing import TYPE_CHECKING

import pytest

from zbot.security.certificate import Validity
from zbot.security.keystore import Keystore
from zbot.web.server import page_certificate
from zbot.web.server.page_certificate import PageCertificate, fingerprint, tls_context

if TYPE_CHECKING:
    from datetime import tzinfo
    from pathlib import Path

ANY = "0.0.0.0"


@pytest.fixture(autouse=True)
def settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    move_to(monkeypatch, "192.168.1.5")
    return tmp_path / "zbot" / "page-certificate"


def move_to(monkeypatch: pytest.MonkeyPatch, *addresses: str) -> None:
    monkeypatch.setattr(page_certificate, "own_addresses", lambda: list(addresses))


def test_a_certificate_is_for_all_names_of_the_machine_and_stays() -> None:
    _, first = page_certificate.page_certificate(ANY)
    assert {"localhost", "127.0.0.1", "::1", "192.168.1.5"} <= set(first.addresses)
    assert page_certificate.page_certificate(ANY)[1] == first


def test_a_given_host_is_in_the_certificate() -> None:
    assert "lab.example" in page_certificate.page_certificate("Lab.Example")[1].addresses


def test_a_new_address_renews_the_certificate_and_keeps_the_authority(
    settings: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = page_certificate.page_certificate(ANY)[1]
    authority = (settings / "public" / "ca.cert.pem").read_bytes()
    move_to(monkeypatch, "10.0.0.9")
    second = page_certificate.page_certificate(ANY)[1]
    assert first.fingerprint != second.fingerprint
    assert "10.0.0.9" in second.addresses
    assert "192.168.1.5" not in second.addresses
    assert (settings / "public" / "ca.cert.pem").read_bytes() == authority


@pytest.mark.parametrize("days_left", [-1, 5])
def test_a_certificate_that_soon_expires_is_renewed(settings: Path, days_left: int) -> None:
    first = page_certificate.page_certificate(ANY)[1]
    now = datetime.now(timezone.utc)
    validity = Validity(now - timedelta(days=30), now + timedelta(days=days_left))
    Keystore(settings).issue("page", first.addresses, validity, renew=True)
    assert page_certificate.page_certificate(ANY)[1].until > now + timedelta(days=300)


def test_the_certificate_of_a_running_page_is_renewed_before_it_expires(
    settings: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines: list[str] = []
    page, first_tls = running_page(settings, lines)
    assert page.tls() is first_tls
    wait(monkeypatch, days=10)
    second_tls = page.tls()
    assert page.tls() is second_tls
    client = ssl.create_default_context(cafile=str(settings / "public" / "ca.cert.pem"))
    shown = hashlib.sha256(peer_certificate(client, second_tls, "localhost")).hexdigest()
    assert shown == page.fingerprint.replace(":", "").lower()
    assert lines == [f"the certificate was renewed: SHA-256 {page.fingerprint}"]


def test_a_running_page_says_once_that_its_certificate_cannot_be_renewed(
    settings: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines: list[str] = []
    page, first_tls = running_page(settings, lines)
    wait(monkeypatch, days=10)
    monkeypatch.setattr(page_certificate, "settings_folder", lambda: settings / "kept.key" / "sub")
    (settings / "kept.key").write_text("a file in the place of a folder")
    assert page.tls() is first_tls
    assert page.tls() is first_tls
    (line,) = lines
    assert line.startswith("the certificate expires on ")
    assert "and cannot be renewed: cannot use " in line


def running_page(settings: Path, lines: list[str]) -> tuple[PageCertificate, ssl.SSLContext]:
    """Return the certificate of a page, which is valid for 20 days, and its TLS settings."""
    names = page_certificate.page_certificate(ANY)[1].addresses
    Keystore(settings).issue("page", names, Validity.days(20), renew=True)
    page = PageCertificate(ANY, lines.append)
    return page, page.tls()


def wait(monkeypatch: pytest.MonkeyPatch, days: int) -> None:
    """Let some days go by."""

    class Later(datetime):
        @classmethod
        def now(cls, tz: tzinfo | None = None) -> Later:
            return super().now(tz) + timedelta(days=days)

    monkeypatch.setattr(page_certificate, "datetime", Later)


def test_an_authority_that_is_damaged_or_ends_too_early_is_replaced(settings: Path) -> None:
    page_certificate.page_certificate(ANY)
    (settings / "public" / "ca.cert.pem").write_text("no certificate")
    identity, _ = page_certificate.page_certificate(ANY)
    identity.check()
    damaged = Keystore.create(settings.parent / "short", Validity.days(100))
    (damaged.root / "public" / "ca.cert.pem").replace(settings / "public" / "ca.cert.pem")
    page_certificate.page_certificate(ANY)[0].check()


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file modes")
def test_only_the_owner_can_read_the_files(settings: Path) -> None:
    page_certificate.page_certificate(ANY)
    modes = {stat.S_IMODE(path.stat().st_mode) for path in (settings, *settings.rglob("*"))}
    assert modes == {0o700, 0o600}


def test_a_client_that_knows_the_authority_accepts_the_certificate(settings: Path) -> None:
    identity, found = page_certificate.page_certificate(ANY)
    client_context = ssl.create_default_context(cafile=str(settings / "public" / "ca.cert.pem"))
    for name in ("localhost", "192.168.1.5", "::1"):
        assert peer_certificate(client_context, tls_context(identity), name)
    with pytest.raises(ssl.SSLCertVerificationError):
        peer_certificate(client_context, tls_context(identity), "10.0.0.9")
    assert fingerprint(found).replace(":", "").lower() == found.fingerprint


def peer_certificate(client: ssl.SSLContext, server: ssl.SSLContext, name: str) -> bytes:
    """Return the certificate (DER) that a client accepts, without a network."""
    to_server, to_client = ssl.MemoryBIO(), ssl.MemoryBIO()
    client_side = client.wrap_bio(to_client, to_server, server_hostname=name)
    server_side = server.wrap_bio(to_server, to_client, server_side=True)
    for side in (client_side, server_side, client_side, server_side):
        try:
            side.do_handshake()
        except ssl.SSLWantReadError:
            continue
    return client_side.getpeercert(binary_form=True) or b""
