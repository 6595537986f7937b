"""Tests of the generated CDR code of every message type, with random values and damaged bytes."""

from __future__ import annotations

import contextlib
import tracemalloc
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import zbot  # noqa: F401 - makes the messages importable
from tests.unit.wire.cdr.reference_cdr import reference_cdr
from tests.unit.wire.random_message import message_of, random_message, shipped_messages
from zbot.interfaces import get_interface
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.errors import CodecError

NAMES = shipped_messages()
#: Types with fields of every kind: lists with and without bounds, wide text, messages in messages.
KINDS = [name for name in NAMES if name.startswith("test_msgs/")]
#: Types with more random values and more places where they are cut.
MANY = {*KINDS, *NAMES[::5]}


def check(message: Any) -> bytes:
    """Check that a message has the bytes of the reference, and that it is read from them."""
    codec = cdr_codec_for(type(message))
    data = codec.encode(message)
    assert data == reference_cdr(message)
    assert codec.decode(data) == message
    assert codec.decode(data + b"more") == message
    assert codec.decode(reference_cdr(message, ">")) == message
    return data


@pytest.mark.parametrize("part", range(4))
def test_every_shipped_type_has_the_bytes_of_the_reference(part: int) -> None:
    assert len(NAMES) > 300
    for name in NAMES[part::4]:
        for attempt in range(3 if name in MANY else 1):
            check(random_message(get_interface(name), Random(f"{name} {attempt}")))


@settings(max_examples=300)
@given(st.sampled_from(NAMES), st.randoms(use_true_random=False))
def test_random_values_go_there_and_back(name: str, random: Random) -> None:
    check(random_message(get_interface(name), random))


@pytest.mark.parametrize("order", ["<", ">"])
def test_a_message_of_any_type_that_is_cut_is_refused(order: str) -> None:
    for name in NAMES if order == "<" else NAMES[::5]:
        message, places = message_of(name), 40 if name in MANY else 12
        decode, data = cdr_codec_for(type(message)).decode, reference_cdr(message, order)
        for end in {*range(min(len(data), places)), *range(0, len(data), 1 + len(data) // places)}:
            with pytest.raises(CodecError, match="cannot decode"):
                decode(data[:end])


@settings(max_examples=500)
@given(
    st.sampled_from(NAMES),
    st.randoms(use_true_random=False),
    st.lists(st.tuples(st.integers(0, 2**20), st.binary(min_size=1, max_size=4)), max_size=3),
)
def test_damaged_bytes_give_a_message_or_one_error(
    name: str, random: Random, damages: list[tuple[int, bytes]]
) -> None:
    codec = cdr_codec_for(get_interface(name))
    damaged = bytearray(codec.encode(random_message(get_interface(name), random)))
    for place, octets in damages:
        begin = 4 + place % len(damaged)
        damaged[begin : begin + len(octets)] = octets
    try:
        message = codec.decode(bytes(damaged))
    except CodecError:
        return
    codec.encode(message)


@pytest.mark.parametrize("order", ["<", ">"])
def test_a_large_count_in_any_place_takes_little_memory(order: str) -> None:
    names = [*KINDS, *NAMES[::40]] if order == "<" else NAMES[::40]
    messages = [message_of(name) for name in names]
    for message in messages:
        codec = cdr_codec_for(type(message))
        data = reference_cdr(message, order)
        codec.decode(data)  # compiles the code
        with contextlib.suppress(CodecError):
            codec.decode(data[:4])  # compiles the code for values that are not valid
    tracemalloc.start()
    try:
        for message in messages:
            _check_memory_of_large_counts(message, order)
    finally:
        tracemalloc.stop()


def _check_memory_of_large_counts(message: Any, order: str) -> None:
    codec, data = cdr_codec_for(type(message)), reference_cdr(message, order)
    little = order == "<"
    count = (0x7FFFFFFF).to_bytes(4, "little" if little else "big")
    for begin in range(4, min(len(data) - 3, 200), 4):
        tracemalloc.reset_peak()
        before = tracemalloc.get_traced_memory()[0]
        with contextlib.suppress(CodecError):
            codec.decode(data[:begin] + count + data[begin + 4 :])
        assert tracemalloc.get_traced_memory()[1] - before < 200_000 + 100 * len(data)
