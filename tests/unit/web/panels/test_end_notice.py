"""Tests of the notice that a recording or a playback has ended early."""

from __future__ import annotations

from pathlib import Path

from zbot.web.panels.bags.end_notice import EndNotice


class Recording:
    """Recording of which the test decides whether it runs."""

    def __init__(self) -> None:
        self.path = Path("lesson")
        self.error = ""
        self.is_running = True

    def end(self, error: str) -> None:
        self.error, self.is_running = error, False


def test_an_early_end_is_told_once() -> None:
    recording = Recording()
    notice = EndNotice("recording", lambda: recording)
    assert notice.news() == ""
    recording.end("the disk is full")
    assert notice.news() == "The recording of lesson has ended: the disk is full"
    assert notice.news() == ""


def test_a_good_end_is_not_told() -> None:
    recording = Recording()
    notice = EndNotice("recording", lambda: recording)
    recording.end("")
    assert notice.news() == ""


def test_what_the_page_knows_is_not_told() -> None:
    recording = Recording()
    notice = EndNotice("recording", lambda: recording)
    recording.end("the disk is full")
    notice.skip()
    assert notice.news() == ""
    assert EndNotice("recording", lambda: recording).news() == ""
