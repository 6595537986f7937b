"""Classes and hubs with `--keystore`: the commands, with every certificate that could go wrong."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.classroom.attacked import PIN, Computer
from tests.classroom.talk import accepts
from tests.classroom.tls_relay import TlsRelay
from tests.conftest import wait_until
from zbot.classroom.hub.address import own_addresses
from zbot.security.access import LOBBY, LOBBY_SECRET, credentials
from zbot.security.keystore import Keystore

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path


ADDRESS = next(iter(own_addresses()), "")
needs_network = pytest.mark.skipif(not ADDRESS, reason="this machine is in no network")


@pytest.fixture
def computer(tmp_path: Path) -> Iterator[Callable[[str], Computer]]:
    """Return a function that makes a computer, which takes part in nothing when the test ends."""
    made: list[Computer] = []

    def make(name: str) -> Computer:
        made.append(Computer(tmp_path / name))
        return made[-1]

    yield make
    for computer_made in reversed(made):
        computer_made.run("leave", "--yes")


@pytest.fixture
def store(tmp_path: Path) -> Keystore:
    made = Keystore.create(tmp_path / "keys")
    made.issue("teacher", [ADDRESS or "127.0.0.1"])
    made.issue("ana")
    return made


@pytest.fixture
def enclaves(store: Keystore) -> Path:
    return store.root / "enclaves"


@needs_network
def test_a_class_with_a_keystore(computer: Callable[[str], Computer], enclaves: Path) -> None:
    teacher, ana = computer("teacher"), computer("ana")
    key = ("--keystore", str(enclaves / "teacher"))
    teacher.do("class", "start", "tls", "--pin", *key, "--port", str(teacher.port), ZBOT_PIN=PIN)
    where = f"{ADDRESS}:{teacher.port}"

    refused = ana.run("join", where, ZBOT_PIN=PIN)
    assert refused.code == 1
    assert "requires a certificate" in refused.err

    own = ("--name", "Ana", "--keystore", str(enclaves / "ana"))
    ana.do("join", where, *own, ZBOT_PIN=PIN)
    assert wait_until(lambda: "Ana" in teacher.do("class", "list"), 20)
    assert wait_until(lambda: "linked" in ana.do("status"), 20)

    # Neither credentials nor the lobby's get in past the certificates, by TCP or by TLS.
    for paths in (ana.credentials, credentials(LOBBY, LOBBY_SECRET)):
        for protocol in ("tcp", "tls"):
            elsewhere = {"connect/endpoints": [f"{protocol}/{where}"]}
            assert not accepts(0, {**paths, **elsewhere})


@needs_network
def test_join_through_a_relay_with_a_certificate_of_the_keystore(
    computer: Callable[[str], Computer], enclaves: Path, store: Keystore
) -> None:
    teacher, ana = computer("teacher"), computer("ana")
    key = ("--keystore", str(enclaves / "teacher"))
    teacher.do("class", "start", "tls", "--pin", *key, "--port", str(teacher.port), ZBOT_PIN=PIN)
    relay = TlsRelay(store.issue("relay", [ADDRESS]), ADDRESS, teacher.port)
    own = ("--name", "Ana", "--keystore", str(enclaves / "ana"))
    refused = ana.run("join", f"{ADDRESS}:{relay.port}", *own, ZBOT_PIN=PIN)
    relay.close()
    assert b"enrol" in relay.went
    assert refused.code == 1
    assert refused.err.startswith("this laptop did not dial the class's own machine")
    assert not ana.has_joined


@needs_network
def test_foreign_certificates_do_not_join(
    computer: Callable[[str], Computer], enclaves: Path, tmp_path: Path
) -> None:
    teacher, eve = computer("teacher"), computer("eve")
    foreign = Keystore.create(tmp_path / "other").issue("eve").folder
    key = ("--keystore", str(enclaves / "teacher"))
    teacher.do("class", "start", *key, "--port", str(teacher.port))
    refused = eve.run("join", f"{ADDRESS}:{teacher.port}", "--keystore", str(foreign))
    assert refused.code == 1
    assert "was not made with the keystore" in refused.err
    assert "joined nothing" in eve.do("status")


def test_a_class_does_not_open_with_a_certificate_that_nobody_could_join(
    computer: Callable[[str], Computer], enclaves: Path, store: Keystore
) -> None:
    teacher = computer("teacher")
    store.issue("elsewhere", ["10.99.99.99"])
    for name, sentence in (("ana", "names no address"), ("elsewhere", "is for 10.99.99.99")):
        refused = teacher.run("class", "start", "--keystore", str(enclaves / name))
        assert refused.code == 1
        assert sentence in refused.err
    refused = teacher.run("class", "start", "--keystore", "nowhere")
    assert (refused.code, refused.out) == (1, "")
    assert "there is no keystore at nowhere" in refused.err
    assert teacher.run("class", "list").code == 1


@needs_network
def test_two_machines_with_a_keystore(computer: Callable[[str], Computer], enclaves: Path) -> None:
    one, other = computer("one"), computer("other")
    key = ("--keystore", str(enclaves / "teacher"))
    where = f"{ADDRESS}:{one.port}"
    with one.background("hub", "--listen", where, *key) as hub:
        hub.wait_for("zbot join")
        joined = other.do("join", where, "--keystore", str(enclaves / "ana"))
        assert joined.startswith(f"joined {where}")
        assert wait_until(lambda: "linked" in other.do("status"), 20)


@needs_network
def test_the_error_says_which_hub_lacks_a_keystore(
    computer: Callable[[str], Computer], enclaves: Path
) -> None:
    one, other = computer("one"), computer("other")
    where = f"{ADDRESS}:{one.port}"
    with one.background("hub", "--listen", where) as hub:
        hub.wait_for("zbot join")
        refused = other.run("join", where, "--keystore", str(enclaves / "ana"))
    assert refused.code == 1
    assert "uses no certificates: join without --keystore" in refused.err
