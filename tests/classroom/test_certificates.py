"""TLS between hubs: real Zenoh routers on loopback, with every certificate that could go wrong."""

from __future__ import annotations

import socket
import ssl
from dataclasses import replace
from datetime import datetime, timedelta, timezone
from typing import TYPE_CHECKING, Any

import pytest
import zenoh

from tests.classroom.talk import HERE, free_port, open_session
from tests.conftest import wait_until
from zbot.classroom.student.link_problem import certificate_problem
from zbot.security.certificate import Validity
from zbot.security.errors import SecurityError
from zbot.security.keystore import Identity, Keystore
from zbot.security.tls import check_dialling, check_listening, tls_settings
from zbot.transport.membership import Membership

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path


NOW = datetime.now(timezone.utc)
PAST = Validity(NOW - timedelta(days=3), NOW - timedelta(days=1))
FUTURE = Validity(NOW + timedelta(days=1), NOW + timedelta(days=3))


@pytest.fixture
def store(tmp_path: Path) -> Keystore:
    return Keystore.create(tmp_path / "keys")


@pytest.fixture
def foreign(tmp_path: Path) -> Keystore:
    return Keystore.create(tmp_path / "foreign")


@pytest.fixture
def listen() -> Iterator[Callable[..., int]]:
    """Return a function that opens a hub and returns its port."""
    opened: list[zenoh.Session] = []

    def start(identity: Identity | None, **more: Any) -> int:
        port = free_port()
        protocol, settings = ("tls", tls_settings(identity)) if identity else ("tcp", {})
        endpoints = {"listen/endpoints": [f"{protocol}/{HERE}:{port}"]}
        opened.append(open_session({"mode": "router", **endpoints, **settings, **more}))
        return port

    yield start
    for session in opened:
        session.close()


def links(port: int, settings: dict[str, Any], protocol: str = "tls") -> bool:
    """Return whether a hub that dials a port is accepted."""
    dial = {
        "mode": "router",
        "listen/endpoints": [],
        "connect/endpoints": [f"{protocol}/{HERE}:{port}"],
        "connect/timeout_ms": 0,
        "connect/exit_on_failure": True,
    }
    try:
        session = open_session({**dial, **settings})
    except zenoh.ZError:
        return False
    linked = wait_until(lambda: bool(session.info.routers_zid()))
    session.close()
    return linked


def test_two_machines_of_one_keystore_are_linked(
    store: Keystore, listen: Callable[..., int]
) -> None:
    teacher, ana = store.issue("teacher", [HERE]), store.issue("ana")
    port = listen(teacher)
    assert check_listening(teacher, HERE).name == "teacher"
    assert check_dialling(ana, HERE, port).name == "teacher"
    assert links(port, tls_settings(ana))


def invalid(store: Keystore, foreign: Keystore, what: str) -> Identity:
    """Return a student's certificate that should not be accepted."""
    if what == "foreign":
        found = foreign.issue("ana")
        found.authority.write_bytes((store.root / "public/ca.cert.pem").read_bytes())
        return found
    return store.issue("ana", validity={"expired": PAST, "early": FUTURE}[what])


@pytest.mark.parametrize(
    ("what", "problem"),
    [
        ("expired", "expired on"),
        ("early", "is valid only from"),
        ("foreign", "not made with the keystore"),
    ],
)
def test_an_invalid_certificate_is_rejected_by_zbot_and_by_the_hub(
    store: Keystore,
    foreign: Keystore,
    listen: Callable[..., int],
    what: str,
    problem: str,
) -> None:
    port, ana = listen(store.issue("teacher", [HERE])), invalid(store, foreign, what)
    with pytest.raises(SecurityError, match=problem):
        check_dialling(ana, HERE, port)
    assert not links(port, tls_settings(ana))
    assert links(port, tls_settings(store.issue("ben")))


def test_a_hub_rejects_a_peer_without_a_certificate(
    store: Keystore, listen: Callable[..., int]
) -> None:
    port, ana = listen(store.issue("teacher", [HERE])), store.issue("ana")
    anonymous = {
        path: value for path, value in tls_settings(ana).items() if "/connect_" not in path
    }
    assert not links(port, anonymous)
    assert not links(port, {}, "tcp")
    ana.certificate.unlink()
    with pytest.raises(SecurityError):
        check_dialling(ana, HERE, port)


@pytest.mark.parametrize(
    ("what", "problem"),
    [
        ("expired", "expired on"),
        ("early", "is valid only from"),
        ("foreign", "not made with the keystore"),
        ("a student's", "names no address"),
        ("for another address", "is for 10.9.9.9, not for"),
    ],
)
def test_a_hub_with_an_invalid_certificate_neither_starts_nor_is_trusted(
    store: Keystore,
    foreign: Keystore,
    listen: Callable[..., int],
    what: str,
    problem: str,
) -> None:
    ana = store.issue("ana")
    made = {
        "expired": lambda: store.issue("impostor", [HERE], PAST),
        "early": lambda: store.issue("impostor", [HERE], FUTURE),
        "foreign": lambda: foreign.issue("impostor", [HERE]),
        "a student's": lambda: store.issue("impostor"),
        "for another address": lambda: store.issue("impostor", ["10.9.9.9"]),
    }[what]()
    if what != "foreign":  # which is valid in its own keystore
        with pytest.raises(SecurityError, match=problem):
            check_listening(made, HERE)
    port = listen(made)
    with pytest.raises(SecurityError, match=problem):
        check_dialling(ana, HERE, port)
    assert not links(port, tls_settings(ana))


def test_a_client_certificate_is_rejected_for_a_hub(
    store: Keystore, listen: Callable[..., int]
) -> None:
    port = listen(store.issue("eve"))
    trusting = tls_settings(store.issue("ana"))
    trusting["transport/link/tls/verify_name_on_connect"] = False
    assert not links(port, trusting)


def test_a_hub_that_rejects_our_certificate_is_reported(
    store: Keystore, foreign: Keystore, listen: Callable[..., int]
) -> None:
    teacher, ana = store.issue("teacher", [HERE]), store.issue("ana")
    teacher.authority.write_bytes((foreign.root / "public/ca.cert.pem").read_bytes())
    port = listen(teacher)
    with pytest.raises(SecurityError, match="does not accept this machine's certificate"):
        check_dialling(ana, HERE, port)
    assert not links(port, tls_settings(ana))


def test_a_hub_without_a_keystore_is_reported(store: Keystore, listen: Callable[..., int]) -> None:
    port = listen(None)
    with pytest.raises(SecurityError, match="without --keystore"):
        check_dialling(store.issue("ana"), HERE, port)


def test_a_link_ends_when_its_certificate_expires(
    store: Keystore, listen: Callable[..., int]
) -> None:
    port = listen(store.issue("teacher", [HERE]))
    soon = Validity(PAST.since, datetime.now(timezone.utc) + timedelta(seconds=8))
    settings = tls_settings(store.issue("ana", validity=soon))
    session = open_session(
        {
            "mode": "router",
            "listen/endpoints": [],
            "connect/endpoints": [f"tls/{HERE}:{port}"],
            **settings,
        }
    )
    assert wait_until(lambda: bool(session.info.routers_zid()))
    assert wait_until(lambda: not list(session.info.routers_zid()), 30)
    session.close()


def test_what_travels_between_hubs_is_encrypted(
    store: Keystore, listen: Callable[..., int]
) -> None:
    port, ana = listen(store.issue("teacher", [HERE])), store.issue("ana")
    context = ssl.create_default_context(cafile=ana.authority)
    context.load_cert_chain(ana.certificate, ana.key)
    with socket.create_connection((HERE, port), 2) as plain:
        wrapped = context.wrap_socket(plain, server_hostname=HERE)
        assert wrapped.version() == "TLSv1.3"
        wrapped.close()


def test_the_status_of_a_laptop_says_why_it_is_not_linked(
    store: Keystore, listen: Callable[..., int]
) -> None:
    ana = store.issue("ana")
    joined = Membership("student", HERE, listen(store.issue("teacher", [HERE])))
    joined = replace(joined, keystore=str(ana.folder))
    assert certificate_problem(joined) is None
    assert certificate_problem(replace(joined, port=free_port())) is None
    store.issue("ana", validity=PAST, renew=True)
    assert "expired on" in str(certificate_problem(joined))
