"""The displays of a view share a budget fairly, and large clouds are thinned to fit."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from zbot.tf2.rigid import Rigid
from zbot.view.budget import Budget, fair_shares, size_of
from zbot.view.colors import same
from zbot.view.server.server import bytes_per_s
from zbot.view.shape import Axes, Frustum, Item, Label, Lines, Picture, Plane, Points


def cloud(count: int) -> Item:
    return Item("a", 0, (Points(np.zeros((count, 3), np.float32), same((0, 0, 0), count)),))


def count_of(item: Item) -> int:
    shape: Any = item.shapes[0]
    assert len(shape.positions) == len(shape.colors)
    return len(shape.positions)


def test_small_demands_are_met_and_large_ones_share_the_rest() -> None:
    shares = fair_shares(100, {"cloud": 1000, "scan": 10, "other": 500})
    assert shares == {"scan": 10, "other": 45, "cloud": 45}


def test_what_nobody_demands_is_shared_too() -> None:
    assert fair_shares(100, {"a": 10, "b": 30}) == {"a": 40, "b": 60}
    assert fair_shares(100, {}) == {}


def test_a_cloud_is_thinned_until_it_is_drawn_three_times_a_second() -> None:
    budget = Budget(30_000)
    budget.plan({"cloud": 1e6})
    fitting = budget.fitting("cloud", cloud(100_000))
    assert 900 < count_of(fitting) <= 1000
    assert size_of(fitting) * 3 <= 27_000


def test_a_small_item_is_the_same_object() -> None:
    budget = Budget(200_000)
    budget.plan({"scan": 30_000.0})
    item = cloud(360)
    assert budget.fitting("scan", item) is item


def test_a_display_waits_until_its_share_allows_more() -> None:
    budget = Budget(100_000)
    budget.plan({"a": 1e6, "b": 1e6})
    assert budget.is_due("a", 5.0)
    budget.spend("a", 45_000, 5.0)
    assert not budget.is_due("a", 5.8)
    assert budget.is_due("b", 5.8)
    assert budget.is_due("a", 5.95)


def test_displays_that_are_gone_are_forgotten() -> None:
    budget = Budget(1000)
    for number in range(10):
        budget.plan({str(number): 1e6})
        budget.spend(str(number), 1e6, 0.0)
    assert [*budget._due_s] == ["9"]


def test_without_a_budget_nothing_waits_or_is_thinned() -> None:
    budget = Budget(None)
    budget.plan({"a": 1e9})
    budget.spend("a", 1e9, 5.0)
    item = cloud(100_000)
    assert budget.is_due("a", 5.0)
    assert budget.fitting("a", item) is item


@pytest.mark.parametrize(
    ("host", "choice", "expected"),
    [
        ("127.0.0.1", None, None),
        ("0.0.0.0", None, 200_000),
        ("0.0.0.0", 0, None),
        ("127.0.0.1", 50, 50_000),
    ],
)
def test_only_other_machines_have_a_usual_budget(
    host: str, choice: float | None, expected: float | None
) -> None:
    assert bytes_per_s(host, choice) == expected


def test_the_size_of_each_shape_is_known() -> None:
    ends = np.zeros((10, 2, 3), np.float32)
    shapes: dict[float, Any] = {
        90.0: Points(np.zeros((10, 3), np.float32), same((0, 0, 0), 10)),
        300.0: Lines(ends, same((0, 0, 0), 10, 2)),
        280.0: Axes((Rigid(),) * 10),
        400.0: Frustum(Picture(b"a" * 300, "image/png"), 1.0),
        3.0: Plane(np.zeros((1, 10, 3), np.uint8), 1, 1, Rigid()),
        200.0: Label("a"),
    }
    for size, shape in shapes.items():
        assert size_of(Item("", 0, (shape,))) == size
