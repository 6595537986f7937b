"""The comparison that the tests of the pages use finds differences."""

from __future__ import annotations

import pytest

from tests.docs.expected_output import ExpectedOutput


@pytest.mark.parametrize(
    ("page", "output", "is_right"),
    [
        ("/a\n/b", "/a\n/b\n", True),
        ("/a", "/a\n/b\n", False),
        ("/a\n/b", "/b\n/a\n", False),
        ("", "/a\n", False),
        ("", "", True),
        ("/a\n...\n/z", "/a\n/b\n/c\n/z\n", True),
        ("/a\n...\n/z", "/a\n/z\n/b\n", False),
        ("...\nend", "end\nend\n", True),
        ("...", "anything\n", True),
        ("x: 5.544444", "x: 7.1\n", True),
        ("x: 2.0", "x: 3.0\n", False),
        ("number 7", "number 8\n", False),
        ("1  Ana   0.1", "1      Ana  0.1\n", True),
        ("hello ...!", "hello Ana!\n", True),
    ],
)
def test_an_output_is_compared_with_the_page(page: str, output: str, is_right: bool) -> None:
    assert ExpectedOutput(page.splitlines()).matches(output) == is_right


@pytest.mark.parametrize(
    ("page", "output", "is_right"),
    [
        ("Hello: 0", "Hello: 7\nHello: 8\n", True),
        ("Hello: 0", "Hello: 7", False),
        ("Hello: 0", "Bye: 0\n", False),
        ("...\nHello: 0", "Bye: 0\nHello: 1\n", True),
        ("...\nHello: 0", "Bye: 0\n", False),
    ],
)
def test_a_program_that_goes_on_may_say_more(page: str, output: str, is_right: bool) -> None:
    assert ExpectedOutput(page.splitlines(), is_endless=True).matches(output) == is_right
