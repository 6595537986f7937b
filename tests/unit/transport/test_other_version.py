"""Sentences about other versions of zbot."""

from __future__ import annotations

from zbot.transport.other_version import other_versions_text
from zbot.version import __version__


def test_the_same_version_and_an_unknown_one_need_no_sentence() -> None:
    assert not other_versions_text({"Ana": __version__, "Ben": ""})


def test_another_version_is_one_sentence() -> None:
    text = other_versions_text({"Ana": "9.9.9", "Ben": __version__})
    assert text == (
        "zbot has different versions: Ana has 9.9.9, and this machine has "
        f"{__version__}. Install one version everywhere"
    )


def test_many_other_versions_are_still_one_line() -> None:
    text = other_versions_text({f"laptop {number}": "9.9.9" for number in range(30)})
    assert "laptop 4 has 9.9.9 and 25 more, and this machine" in text
