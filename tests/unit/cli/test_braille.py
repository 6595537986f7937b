from __future__ import annotations

import math

import pytest

from zbot_cli.output.braille import Canvas, Curve, draw, span, ticks


def test_dots_have_the_positions_of_braille() -> None:
    canvas = Canvas(1, 1)
    for x, y, text in [(0, 0, "⠁"), (1, 3, "⢁"), (0, 3, "⣁"), (1, 0, "⣉")]:
        canvas.dot(x, y, 0)
        assert list(canvas.rows(coloured=False)) == [text]
    canvas.dot(2, 0, 0)
    canvas.dot(0, -1, 0)
    assert list(canvas.rows(coloured=False)) == ["⣉"]


def test_line_has_no_gaps() -> None:
    canvas = Canvas(2, 1)
    canvas.line((0, 0), (3, 3), 0)
    assert list(canvas.rows(coloured=False)) == ["⠑⢄"]


@pytest.mark.parametrize(
    ("low", "high", "most", "expected"),
    [
        (0, 10, 5, [0, 2, 4, 6, 8, 10]),
        (-1, 1, 4, [-1, -0.5, 0, 0.5, 1]),
        (0.1, 0.9, 2, [0.5]),
        (3, 3, 4, [3]),
        (1e9, 1e9 + 10, 2, [1e9, 1e9 + 5, 1e9 + 10]),
    ],
)
def test_ticks_are_round_numbers(low: float, high: float, most: int, expected: list[float]) -> None:
    assert ticks(low, high, most) == pytest.approx(expected)


def test_range_is_never_empty() -> None:
    for values in ([], [3.0], [0.0, 0.0], [math.nan, math.inf], [-5.0, 5.0]):
        low, high = span(values)
        assert low < high


def sine(count: int = 200) -> Curve:
    return Curve("/wave.y", [(i / 20, math.sin(i / 20)) for i in range(count)])


@pytest.mark.parametrize(("width", "height"), [(80, 24), (40, 12), (200, 60)])
def test_plot_has_exactly_the_given_size(width: int, height: int) -> None:
    lines = draw([sine()], width=width, height=height, from_s=0, to_s=10)
    assert len(lines) == height
    assert max(map(len, lines)) == width
    assert "/wave.y" in lines[0]
    assert any("⠁" <= mark <= "⣿" for line in lines for mark in line)


def test_sine_goes_up_and_down() -> None:
    lines = draw([sine()], width=60, height=20, from_s=0, to_s=10)
    drawn = [
        line[line.index("│") + 1 if "│" in line else line.index("┤") + 1 :] for line in lines[1:-2]
    ]
    rows = [[row for row, text in enumerate(drawn) if text[x] > "⠀"] for x in range(50)]
    means = [sum(row) / len(row) for row in rows if row]
    assert min(means) < 3
    assert max(means) > 12


def test_small_size_has_a_plot() -> None:
    assert len(draw([sine()], width=1, height=1, from_s=0, to_s=10)) >= 3


def test_nan_leaves_a_gap() -> None:
    curve = Curve("/x.y", [(0, 0.0), (1, math.nan), (2, math.inf), (3, 1.0)])
    lines = draw([curve], width=60, height=12, from_s=0, to_s=4)
    assert sum(mark > "⠀" and mark <= "⣿" for line in lines for mark in line) == 2


def test_curves_have_different_colours() -> None:
    lines = draw([sine(), Curve("/b.y", [])], width=60, height=12, from_s=0, to_s=9, coloured=True)
    assert "\033[38;5;33m" in lines[0]
    assert "\033[38;5;208m" in lines[1]
    assert "no message yet" in lines[1]
