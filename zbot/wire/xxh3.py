"""Hash function XXH3 with 128 bits, with which rmw_zenoh makes the gids of endpoints.

The specification is https://github.com/Cyan4973/xxHash. Only inputs of at least 17 bytes are
implemented, because every token is longer.
"""

from __future__ import annotations

from struct import unpack_from

__all__ = ["MIN_LENGTH", "xxh3_128"]

MIN_LENGTH = 17  #: bytes of the shortest input

_P32 = (0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D)
_P64 = (
    0x9E3779B185EBCA87,
    0xC2B2AE3D27D4EB4F,
    0x165667B19E3779F9,
    0x85EBCA77C2B2AE63,
    0x27D4EB2F165667C5,
)
_AVALANCHE = 0x165667919E3779F9
_SECRET = bytes.fromhex(
    "b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671f"
    "cb79e64eccc0e578825ad07dccff7221b8084674f743248ee03590e6813a264c"
    "3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8"
    "a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364"
    "eac5ac8334d3ebc3c581a0fffa1363eb170ddd51b7f0da49d316552629d4689e"
    "2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e"
)
_MASK = (1 << 64) - 1
_LOW = (1 << 32) - 1
_STRIPE = 64
_STRIPES_OF_BLOCK = 16
_MIDDLE, _LONG = 128, 240  # longest inputs of the two methods for short inputs


def xxh3_128(data: bytes) -> bytes:
    """Return the hash, 16 bytes, with the lower half first and each half in little-endian order.

    Raises:
        ValueError: The input has less than 17 bytes.
    """
    if len(data) < MIN_LENGTH:
        raise ValueError(f"the input has {len(data)} bytes and needs at least {MIN_LENGTH}")
    low, high = _long(data) if len(data) > _LONG else _short(data)
    return (low | high << 64).to_bytes(16, "little")


def _word(data: bytes, offset: int) -> int:
    number: int = unpack_from("<Q", data, offset)[0]
    return number


def _fold(one: int, other: int) -> int:
    product = one * other
    return (product ^ (product >> 64)) & _MASK


def _avalanche(value: int) -> int:
    value = ((value ^ (value >> 37)) * _AVALANCHE) & _MASK
    return value ^ (value >> 32)


def _mix_16(data: bytes, offset: int, secret: int) -> int:
    return _fold(
        _word(data, offset) ^ _word(_SECRET, secret),
        _word(data, offset + 8) ^ _word(_SECRET, secret + 8),
    )


def _mix_32(
    state: tuple[int, int], data: bytes, first: int, second: int, secret: int
) -> tuple[int, int]:
    low = (state[0] + _mix_16(data, first, secret)) & _MASK
    low ^= (_word(data, second) + _word(data, second + 8)) & _MASK
    high = (state[1] + _mix_16(data, second, secret + 16)) & _MASK
    high ^= (_word(data, first) + _word(data, first + 8)) & _MASK
    return low, high


def _short(data: bytes) -> tuple[int, int]:
    size = len(data)
    state = (size * _P64[0] & _MASK, 0)
    if size <= _MIDDLE:
        for index in reversed(range((size - 1) // 32 + 1)):
            state = _mix_32(state, data, 16 * index, size - 16 * (index + 1), 32 * index)
    else:
        for offset in range(0, _MIDDLE, 32):
            state = _mix_32(state, data, offset, offset + 16, offset)
        state = _avalanche(state[0]), _avalanche(state[1])
        for offset in range(_MIDDLE, size - 31, 32):
            state = _mix_32(state, data, offset, offset + 16, offset - 125)
        state = _mix_32(state, data, size - 16, size - 32, 103)
    low = (state[0] + state[1]) & _MASK
    high = (state[0] * _P64[0] + state[1] * _P64[3] + size * _P64[1]) & _MASK
    return _avalanche(low), -_avalanche(high) & _MASK


def _long(data: bytes) -> tuple[int, int]:
    size = len(data)
    state = [_P32[2], *_P64[:4], _P32[1], _P64[4], _P32[0]]
    for stripe in range((size - 1) // _STRIPE):
        index = stripe % _STRIPES_OF_BLOCK
        _accumulate(state, data, _STRIPE * stripe, 8 * index)
        if index == _STRIPES_OF_BLOCK - 1:
            keys = unpack_from("<8Q", _SECRET, len(_SECRET) - _STRIPE)
            state = [
                ((one ^ (one >> 47) ^ key) * _P32[0]) & _MASK
                for one, key in zip(state, keys, strict=True)
            ]
    _accumulate(state, data, size - _STRIPE, len(_SECRET) - _STRIPE - 7)
    low = _merged(state, 11, size * _P64[0] & _MASK)
    high = _merged(state, len(_SECRET) - _STRIPE - 11, ~(size * _P64[1]) & _MASK)
    return low, high


def _accumulate(state: list[int], data: bytes, offset: int, secret: int) -> None:
    words, keys = unpack_from("<8Q", data, offset), unpack_from("<8Q", _SECRET, secret)
    for index, (word, key) in enumerate(zip(words, keys, strict=True)):
        mixed = word ^ key
        state[index ^ 1] = (state[index ^ 1] + word) & _MASK
        state[index] = (state[index] + (mixed & _LOW) * (mixed >> 32)) & _MASK


def _merged(state: list[int], secret: int, start: int) -> int:
    keys = unpack_from("<8Q", _SECRET, secret)
    parts = (_fold(state[i] ^ keys[i], state[i + 1] ^ keys[i + 1]) for i in range(0, 8, 2))
    return _avalanche((start + sum(parts)) & _MASK)
