from __future__ import annotations

import os
import stat
from datetime import datetime, timedelta, timezone
from typing import TYPE_CHECKING

import pytest

from zbot.security.certificate import MAX_DAYS, Validity
from zbot.security.errors import SecurityError
from zbot.security.keystore import Identity, Keystore, identity

if TYPE_CHECKING:
    from pathlib import Path


NOW = datetime.now(timezone.utc)
PAST = Validity(NOW - timedelta(days=3), NOW - timedelta(days=1))
FUTURE = Validity(NOW + timedelta(days=1), NOW + timedelta(days=3))


@pytest.fixture
def store(tmp_path: Path) -> Keystore:
    return Keystore.create(tmp_path / "keys")


def test_a_certificate_has_its_name_and_validity(store: Keystore) -> None:
    said = store.issue("teacher", ["10.0.0.5", "laptop.local", "fe80::1"]).check()
    assert said.name == "teacher"
    assert said.addresses == ("10.0.0.5", "laptop.local", "fe80::1")
    assert said.is_server
    # NOW is the time when the tests began.
    assert abs(said.until - NOW - timedelta(days=365)) < timedelta(days=1)
    assert said.since < NOW


def test_a_machine_without_addresses_gets_a_client_certificate(store: Keystore) -> None:
    assert not store.issue("ana").check().is_server


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file modes")
def test_everything_in_a_keystore_is_for_its_owner_only(store: Keystore) -> None:
    store.issue("/robots/one", ["10.0.0.5"])
    paths = [store.root, *store.root.rglob("*")]
    modes = {path.is_dir(): set() for path in paths}  # type: dict[bool, set[int]]
    for path in paths:
        modes[path.is_dir()].add(stat.S_IMODE(path.stat().st_mode))
    assert modes == {True: {0o700}, False: {0o600}}
    assert len(paths) == 11


def test_a_machine_is_not_given_the_authoritys_key(store: Keystore) -> None:
    given = store.issue("ana")
    authority_key = (store.root / "private" / "ca.key.pem").read_bytes()
    assert {path.name for path in given.folder.iterdir()} == {"cert.pem", "key.pem", "ca.cert.pem"}
    assert all(path.read_bytes() != authority_key for path in given.folder.iterdir())


def test_nothing_is_overwritten(store: Keystore, tmp_path: Path) -> None:
    with pytest.raises(SecurityError, match=r"Unable to create keystore: keystore .* exists"):
        Keystore.create(store.root)
    before = store.issue("ana").key.read_bytes()
    with pytest.raises(SecurityError, match=r"Unable to create enclave: .* --renew"):
        store.issue("/ana")
    assert (store.root / "enclaves/ana/key.pem").read_bytes() == before
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("x")
    with pytest.raises(SecurityError, match="folder"):
        Keystore.create(tmp_path / "mine")
    with pytest.raises(SecurityError, match="file"):
        Keystore.create(tmp_path / "mine" / "thesis.txt")


def test_an_empty_folder_becomes_a_keystore(tmp_path: Path) -> None:
    (tmp_path / "keys").mkdir()
    assert Keystore.create(tmp_path / "keys").enclaves() == []


def test_renewing_replaces_key_and_certificate(store: Keystore) -> None:
    first = store.issue("ana", validity=PAST)
    old = first.key.read_bytes()
    with pytest.raises(SecurityError):
        first.check()
    assert store.issue("ana", renew=True).check().until > NOW
    assert first.key.read_bytes() != old


def test_enclaves_are_listed_by_name(store: Keystore) -> None:
    for name in ("/robots/one", "ana", "/robots"):
        store.issue(name)
    (store.root / "enclaves" / ".draft").mkdir()
    (store.root / "enclaves" / ".draft" / "cert.pem").touch()
    assert store.enclaves() == ["/ana", "/robots", "/robots/one"]


@pytest.mark.parametrize(
    "name",
    [
        "",
        "/",
        "..",
        "../ana",
        "a/../b",
        "a//b",
        "a/",
        "//a",
        ".hidden",
        "a b",
        "a\nb",
        "a\x00b",
        "C:\\x",
        "<b>",
        "$(id)",
        "ä",
        "a" * 65,
    ],
)
def test_names_that_would_leave_the_keystore_are_refused(store: Keystore, name: str) -> None:
    before = sorted(store.root.parent.rglob("*"))
    with pytest.raises(SecurityError, match="not a valid enclave name"):
        store.issue(name)
    assert sorted(store.root.parent.rglob("*")) == before


@pytest.mark.parametrize("address", ["", "a b", "10.0.0.5/24", "a..b", "x" * 254, "http://a", "ä"])
def test_invalid_addresses_are_refused(store: Keystore, address: str) -> None:
    with pytest.raises(SecurityError, match="neither a host name nor an IP address"):
        store.issue("teacher", [address])
    assert store.enclaves() == []


@pytest.mark.parametrize("days", [0, -1, MAX_DAYS + 1])
def test_a_validity_has_limits(days: int) -> None:
    with pytest.raises(SecurityError, match="not a number of days from 1 to 3650"):
        Validity.days(days)


def test_expired_and_early_certificates_are_distinguished(store: Keystore) -> None:
    with pytest.raises(SecurityError, match=r"the certificate of old .* expired on"):
        store.issue("old", validity=PAST).check()
    with pytest.raises(SecurityError, match=r"new .* valid only from .* clock"):
        store.issue("new", validity=FUTURE).check()


def test_a_certificate_of_another_authority_is_refused(store: Keystore, tmp_path: Path) -> None:
    foreign = Keystore.create(tmp_path / "other").issue("ana")
    foreign.authority.write_bytes((store.root / "public" / "ca.cert.pem").read_bytes())
    with pytest.raises(SecurityError, match="not made with the keystore"):
        foreign.check()


def test_an_authority_with_another_key_is_refused(store: Keystore, tmp_path: Path) -> None:
    one, other = store.issue("ana"), Keystore.create(tmp_path / "other").issue("ana")
    one.authority.write_bytes(other.authority.read_bytes())
    with pytest.raises(SecurityError):
        one.check()


def test_an_expired_authority_is_reported(tmp_path: Path) -> None:
    store = Keystore.create(tmp_path / "keys", PAST)
    with pytest.raises(SecurityError, match=r"zbot keystore .* expired on"):
        store.issue("ana").check()


@pytest.mark.parametrize("name", ["cert.pem", "key.pem", "ca.cert.pem"])
def test_missing_and_damaged_files_are_named(store: Keystore, name: str) -> None:
    ana = store.issue("ana")
    path = ana.folder / name
    path.write_bytes(b"-----BEGIN CERTIFICATE-----\nnonsense\n-----END CERTIFICATE-----\n")
    with pytest.raises(SecurityError, match=f"{name} is not a valid"):
        ana.check()
    path.unlink()
    with pytest.raises(SecurityError, match=f"there is no (key|certificate) at .*{name}"):
        ana.check()


def test_a_key_of_another_certificate_is_refused(store: Keystore) -> None:
    ana, ben = store.issue("ana"), store.issue("ben")
    ana.key.write_bytes(ben.key.read_bytes())
    with pytest.raises(SecurityError, match="does not belong to the certificate"):
        ana.check()


def test_a_copy_without_the_authoritys_key_makes_no_certificates(store: Keystore) -> None:
    (store.root / "private" / "ca.key.pem").unlink()
    with pytest.raises(SecurityError, match="no key to sign with"):
        store.issue("ana")


def test_a_folder_that_is_not_a_keystore_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SecurityError, match="is not a valid keystore"):
        Keystore(tmp_path)


def test_the_identity_of_a_keystore_is_selected(
    store: Keystore, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    with pytest.raises(SecurityError, match="none"):
        identity(store.root)
    ana = store.issue("ana")
    assert identity(store.root) == ana
    assert identity(ana.folder) == ana
    ben = store.issue("ben")
    monkeypatch.setattr("socket.gethostname", lambda: "ben")
    assert identity(store.root) == ben
    monkeypatch.setattr("socket.gethostname", lambda: "eve")
    with pytest.raises(SecurityError, match="ana, ben"):
        identity(store.root)
    with pytest.raises(SecurityError):
        identity(tmp_path / "nowhere")
    with pytest.raises(SecurityError):
        Identity(tmp_path).check()
