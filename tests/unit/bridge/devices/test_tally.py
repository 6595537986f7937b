from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.bridge.devices.tally import Tally
from zbot.log import get_logger

if TYPE_CHECKING:
    from zbot.log.record import Record


def test_the_first_loss_of_a_reason_is_logged_and_later_ones_together(
    logged: list[Record],
) -> None:
    tally = Tally(get_logger("board"), "line")
    for number in range(5):
        tally.lose("it is not text", f"x\x1b{number}", "look at the baud rate")
    tally.lose("too long")
    assert [record.message for record in logged] == [
        "1 line lost: it is not text (x 0); look at the baud rate",
        "1 line lost: too long",
    ]
    tally.report()
    tally.report()
    assert [record.message for record in logged[2:]] == ["4 more lines lost: it is not text (x 4)"]
    tally.received, tally.published = 9, 3
    assert tally.summary() == (
        "9 lines received, 3 published, 5 lost (it is not text), 1 lost (too long)"
    )


def test_reasons_without_end_need_no_memory_without_end() -> None:
    tally = Tally(get_logger("board"), "line")
    for number in range(1000):
        tally.lose(str(number))
    assert tally.lost == 1000
    assert len(tally.summary()) < 5000
