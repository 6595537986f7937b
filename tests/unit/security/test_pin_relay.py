"""A program between laptop and class: it forwards, changes or replaces the documents of a PIN."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import pytest

from zbot.security.pin import PinClient, PinError, PinMessageError, PinServer, WrongPinError
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from collections.abc import Callable

    Document = dict[str, Any]
    Forward = Callable[[Document], Document]

# Random bytes and their hexadecimal digits cannot contain the PIN or the name by chance.
PIN = Secret("pin 471100")
NAME = "Robots"
HUB = "tcp/10.0.0.1:7447"
RELAY = "tcp/10.0.0.66:7447"
REQUEST = {"name": "Anastasia"}
ANSWER = {"secret": "s3cret"}
_FLIPS = (0x01, 0x20)  # another digit, and another case of a letter


class Join:
    """One laptop that joins. Each step forwards a document through a function."""

    def __init__(self, dialled: str = HUB, class_name: str = NAME, pin: Secret = PIN) -> None:
        self.server = PinServer(PIN, NAME, lambda hub: hub == HUB, sleep=lambda _s: None)
        self.client = PinClient(pin, class_name, dialled)

    def run(self, **forward: Forward) -> Document:
        """Return the answer that the laptop reads."""

        def sent(name: str, document: Document) -> Document:
            return forward[name](document) if name in forward else document

        challenge = self.server.challenge(sent("hello", self.client.hello()))
        claim = self.client.claim(sent("challenge", challenge), REQUEST)
        admission = self.server.admit(sent("claim", claim))
        return self.client.opened(sent("answer", admission.seal(ANSWER)))


def flipped(document: Document, position: int, mask: int) -> Document:
    """Return what a hub or laptop reads if one byte of a document has changed on its way."""
    text = bytearray(json.dumps(document).encode())
    text[position] ^= mask
    try:
        found = json.loads(text)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def length_of(name: str) -> int:
    lengths: dict[str, int] = {}

    def measure(name: str) -> Forward:
        def forward(document: Document) -> Document:
            lengths[name] = len(json.dumps(document))
            return document

        return forward

    Join().run(**{step: measure(step) for step in ("hello", "challenge", "claim", "answer")})
    return lengths[name]


@pytest.mark.parametrize("mask", _FLIPS)
@pytest.mark.parametrize("name", ["hello", "challenge"])
def test_a_change_of_any_byte_admits_nobody(name: str, mask: int) -> None:
    length = length_of(name)
    assert length > 100
    for position in range(length):
        join = Join()
        with pytest.raises(PinError):
            join.run(**{name: lambda sent, at=position: flipped(sent, at, mask)})


@pytest.mark.parametrize("mask", _FLIPS)
def test_a_change_of_any_byte_of_the_claim_admits_nobody(mask: int) -> None:
    join, claim = _claimed()
    for position in range(len(json.dumps(claim))):
        with pytest.raises(PinError):
            join.server.admit(flipped(claim, position, mask))
        if not join.server._attempts:  # the class refuses a second claim of this attempt
            join, claim = _claimed()


def _claimed() -> tuple[Join, Document]:
    join = Join()
    return join, join.client.claim(join.server.challenge(join.client.hello()), REQUEST)


def test_a_change_of_any_byte_of_the_answer_is_the_one_named_error() -> None:
    join, claim = _claimed()
    client = join.client
    answer = join.server.admit(claim).seal(ANSWER)
    for position in range(len(json.dumps(answer))):
        for bit in range(8):
            with pytest.raises(PinMessageError):
                client.opened(flipped(answer, position, 1 << bit))
    assert client.opened(answer) == ANSWER


@pytest.mark.parametrize("field", ["claim", "proof", "visit"])
@pytest.mark.parametrize("change", [lambda text: text[:-2], lambda text: text + "00"])
def test_a_shorter_or_longer_claim_is_the_one_named_error(
    field: str, change: Callable[[str], str]
) -> None:
    with pytest.raises(PinMessageError):
        Join().run(claim=lambda sent: sent | {field: change(sent[field])})


def test_a_relay_at_another_address_admits_nobody() -> None:
    with pytest.raises(PinError, match="did not dial the class's own machine"):
        Join(dialled=RELAY).run()


def test_a_relay_cannot_replace_the_address() -> None:
    join = Join(dialled=RELAY)
    with pytest.raises(WrongPinError):
        join.run(hello=lambda sent: sent | {"hub": HUB})
    assert join.server.wrong == 1


def test_a_relay_cannot_rename_the_class() -> None:
    with pytest.raises(WrongPinError):
        Join(class_name="Robots of Eve").run()


def test_a_relay_with_the_true_address_reads_nothing() -> None:
    seen: list[Document] = []

    def record(document: Document) -> Document:
        seen.append(document)
        return document

    steps = ("hello", "challenge", "claim", "answer")
    assert Join().run(**dict.fromkeys(steps, record)) == ANSWER
    carried = b"".join(
        bytes.fromhex(text)
        for document in seen
        for name, text in document.items()
        if name not in {"protocol", "hub"}
    )
    for word in (PIN.reveal(), "Anastasia", "s3cret"):
        assert word not in json.dumps(seen)
        assert word.encode() not in carried


def test_a_relay_cannot_use_parts_of_another_exchange() -> None:
    recorded: dict[str, Document] = {}

    def record(name: str) -> Forward:
        return lambda document: recorded.setdefault(name, document)

    steps = ("hello", "challenge", "claim", "answer")
    Join().run(**{name: record(name) for name in steps})
    for name in steps:
        for field in recorded[name].keys() - {"protocol", "hub"}:
            with pytest.raises(PinError):
                Join().run(**{name: lambda sent, at=name, of=field: sent | {of: recorded[at][of]}})


def test_an_answer_is_not_accepted_as_a_claim() -> None:
    join, claim = _claimed()
    with pytest.raises(PinMessageError):
        join.client.opened({"answer": claim["claim"], "tag": claim["proof"]})


def test_a_relay_that_runs_both_sides_needs_the_pin() -> None:
    join = Join(dialled=RELAY)
    relay = PinServer(Secret("000000"), NAME, lambda _hub: True)
    claim = join.client.claim(relay.challenge(join.client.hello()), REQUEST)
    with pytest.raises(WrongPinError):
        relay.admit(claim)
    with pytest.raises(PinError):  # the laptop's claim is of no use at the class
        join.server.admit(claim)
