"""Tests of the sections of a page."""

from __future__ import annotations

from typing import Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.web.page.panel import Section


class Watch:
    """Something that must be released."""

    def __init__(self) -> None:
        self.releases = 0

    def release(self) -> None:
        self.releases += 1


def section() -> Section:
    page: Any = type("Page", (), {"watches": {}})()
    return Section(page)


def test_the_end_of_a_section_releases_what_it_keeps() -> None:
    kept, dropped = Watch(), Watch()
    one = section()
    one.keep(kept)
    one.drop(one.keep(dropped))
    one.close()
    one.close()
    assert (kept.releases, dropped.releases) == (1, 1)


def test_what_comes_after_the_end_is_released_at_once() -> None:
    late = Watch()
    one = section()
    one.close()
    assert one.keep(late) is late
    assert late.releases == 1


def test_an_inner_section_ends_with_its_outer_one_and_leaves_nothing_in_it() -> None:
    first, second = Watch(), Watch()
    outer = section()
    closed, present = outer.section(), outer.section()
    closed.keep(first)
    present.keep(second)
    closed.close()
    assert list(outer._endings) == [present]
    outer.close()
    outer.close()
    assert (first.releases, second.releases) == (1, 1)
