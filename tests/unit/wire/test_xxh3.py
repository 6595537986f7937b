from __future__ import annotations

import pytest

from zbot.wire.xxh3 import xxh3_128

# Made with the reference implementation, for each way in which the length decides.
_VECTORS = {
    17: "3c0cd9de34e45f7341800863af673f26",
    32: "4c839a5a04207940a576f95846516ba8",
    33: "e49d3cbadfb4598b92d26ee20cd843a9",
    64: "03576512035eaeeda7643bf2f795faa7",
    65: "6fa909990a50955ca482178a5faf2ac1",
    96: "6528187e96f0b9ac54ef68e5d60cfadb",
    97: "7102b6dc3548e6fefe6eea041d6931bc",
    128: "9ff265c8ec21bdc69ccc51bda95a9edd",
    129: "5b488765b7cc4a7f2e878dcf35364300",
    159: "03d281e1c9710a085d96179c97d05e7e",
    160: "d0f268ceacbad408e66e344222238222",
    161: "179fdee6eb66eb814fecc06fb0de5fcc",
    239: "4f074eeb483c85cd2ddc3a14783cfef2",
    240: "b3e499054eeb0bd1255d35eea2a0e389",
    241: "e852006f22191b545ace3cf243daf475",
    256: "b95be7adef1c5aff2dceebb20636432f",
    1024: "5b443c040bcf5adc522f7ff37a9fbb8b",
    1025: "26ae776294cdd9e186ad3f58e09d6020",
    1088: "9431b91219229c4a0feeaa6860b67fff",
    3000: "cfcc598218bb686104813e0b88eab47a",
}


@pytest.mark.parametrize("length", _VECTORS)
def test_the_hash_of_any_length_is_that_of_the_reference_implementation(length: int) -> None:
    data = bytes(index * 7 % 256 for index in range(length))
    assert xxh3_128(data).hex() == _VECTORS[length]


def test_a_shorter_input_is_an_error() -> None:
    with pytest.raises(ValueError, match="16 bytes"):
        xxh3_128(bytes(16))
