"""Options of `zbot class bundle`."""

from __future__ import annotations

import pytest

from zbot.classroom.bundle.errors import BundleError
from zbot.classroom.bundle.target import Target, parse_extras, parse_targets


def test_systems_and_pythons_are_lists_or_spans() -> None:
    found = [str(target) for target in parse_targets("windows, linux-aarch64", "3.11..3.13")]
    assert len(found) == 6
    assert found[0] == "windows-x86_64-3.11"
    assert found[-1] == "linux-aarch64-3.13"
    assert len(parse_targets("macos", "3.10,3.14")) == 4


@pytest.mark.parametrize(
    ("systems", "pythons", "message"),
    [
        ("window", "3.13", "unknown system 'window'; did you mean 'windows'?"),
        ("beos", "3.13", "unknown system 'beos'; write windows, macos, linux"),
        ("", "3.13", "a bundle needs a system and a Python"),
        ("linux", "2.7", "cannot make a bundle for Python '2.7'"),
        ("linux", "3.99", "cannot make a bundle for Python '3.99'"),
        ("linux", "3.11..", "cannot make a bundle for Python ''"),
        ("linux", "3.13..3.11", "the first version is newer than the last one"),
    ],
)
def test_a_bad_option_is_one_sentence(systems: str, pythons: str, message: str) -> None:
    with pytest.raises(BundleError) as raised:
        parse_targets(systems, pythons)
    assert message in str(raised.value)
    assert "\n" not in str(raised.value)


def test_an_unknown_extra_is_named() -> None:
    assert parse_extras("web,bag,web", ["bag", "web"]) == ["web", "bag"]
    assert parse_extras("", ["bag"]) == []
    with pytest.raises(BundleError, match=r"zbot has no extra 'wep'; did you mean 'web'\?"):
        parse_extras("wep", ["bag", "web"])


@pytest.mark.parametrize(
    ("machine", "first", "also"),
    [
        ("windows-x86_64", "cp313-cp313-win_amd64", "py3-none-any"),
        ("macos-arm64", "cp313-cp313-macosx_11_0_arm64", "cp310-abi3-macosx_11_0_universal2"),
        ("linux-aarch64", "cp313-cp313-manylinux_2_28_aarch64", "cp39-abi3-manylinux2014_aarch64"),
    ],
)
def test_the_tags_of_a_target_begin_with_its_own_wheels(
    machine: str, first: str, also: str
) -> None:
    tags = [str(tag) for tag in Target(machine, "3.13").tags()]
    assert tags[0] == first
    assert also in tags
