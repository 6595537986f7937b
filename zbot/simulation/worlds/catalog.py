"""Catalog of the worlds that zbot contains. Lengths are in metres."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot.simulation.worlds.plan import Place, Plan

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

_MAZE = """
+---+---+---+---+---+---+
|   |               |   |
+   +   +---+---+   +   +
|       |       |       |
+---+---+   +   +---+   +
|           |       |   |
+   +---+---+---+   +   +
|   |           |       |
+   +   +---+   +---+---+
|       |   |           |
+   +---+   +---+---+   +
|   |
+---+---+---+---+---+---+
"""
_CELL_M = 0.8


def room() -> Plan:
    """Return the room of the simulated robot, with two boxes in it."""
    plan = Plan()
    plan.room(-2.0, -2.5, 4.0, 2.5)
    plan.box(2.0, 1.3, (0.6, 0.6, 0.5))
    plan.box(-1.0, -1.6, (0.8, 0.6, 0.5))
    return plan


def maze() -> Plan:
    """Return a maze. The robot starts in the upper left corner; the exit is at the lower right."""
    lines = _MAZE.strip("\n").splitlines()
    plan = Plan(start=_corner(1, 2, lines), places={"exit": _corner(11, 22, lines)})
    for row, line in enumerate(lines):
        for column, sign in enumerate(line):
            here = _corner(row, column, lines)
            if sign == "-" and line[column - 1] == "+":
                plan.wall((here.x - _CELL_M / 4, here.y), (here.x + _CELL_M * 3 / 4, here.y))
            elif sign == "|":
                plan.wall((here.x, here.y - _CELL_M / 2), (here.x, here.y + _CELL_M / 2))
    return plan


def _corner(row: int, column: int, lines: Sequence[str]) -> Place:
    """Return the place of a letter. Four columns or two rows are one cell."""
    middle_x, middle_y = (len(lines[0]) - 1) / 2, (len(lines) - 1) / 2
    return Place((column - middle_x) * _CELL_M / 4, (middle_y - row) * _CELL_M / 2)


def warehouse() -> Plan:
    """Return a hall with rows of shelves, and boxes that a robot can push."""
    plan = Plan(start=Place(-5.0, 0.0))
    plan.room(-6.0, -4.0, 6.0, 4.0)
    for y in (-2.6, -0.9, 0.9, 2.6):
        for x in (-2.4, 0.4, 3.2):
            plan.box(x, y, (2.0, 0.5, 1.2))
    for number, (x, y) in enumerate([(-4.2, 1.8), (-4.0, -1.9), (5.1, 0.1), (-1.0, 3.5)]):
        plan.box(x, y, (0.3, 0.3, 0.25), yaw=0.3 * number, mass=0.4, name=f"box{number + 1}")
    return plan


def office() -> Plan:
    """Return a house of six rooms on both sides of a corridor."""
    plan = Plan(start=Place(-4.5, 0.0))
    corners = [Place(x, y) for y in (1.7, -1.7) for x in (-3.6, 0.0, 3.6)]
    plan.places = {f"room{number}": place for number, place in enumerate(corners, start=1)}
    plan.room(-5.4, -3.6, 5.4, 3.6)
    for side in (-1, 1):
        for left in (-5.4, -1.8, 1.8):
            door = left + 1.2
            plan.wall((left, 0.7 * side), (door, 0.7 * side))
            plan.wall((door + 1.0, 0.7 * side), (left + 3.6, 0.7 * side))
        for x in (-1.8, 1.8):
            plan.wall((x, 0.7 * side), (x, 3.6 * side))
        for x in (-3.6, 0.0, 3.6):
            plan.box(x + 0.6, 2.7 * side, (1.4, 0.7, 0.5))  # a desk
            plan.pillar(x - 1.2, 3.1 * side, 0.4)
    return plan


def arena() -> Plan:
    """Return a round arena with pillars, and boxes that a robot can push."""
    plan = Plan()
    corners = [(4 * math.cos(angle), 4 * math.sin(angle)) for angle in _angles(24)]
    plan.wall(*corners, corners[0])
    for angle in _angles(6):
        plan.pillar(2.4 * math.cos(angle), 2.4 * math.sin(angle), 0.3)
    for number, angle in enumerate(_angles(3)):
        x, y = 1.3 * math.cos(angle + 0.5), 1.3 * math.sin(angle + 0.5)
        plan.box(x, y, (0.25, 0.25, 0.25), yaw=angle, mass=0.3, name=f"box{number + 1}")
    return plan


def _angles(count: int) -> list[float]:
    return [2 * math.pi * part / count for part in range(count)]


#: The worlds by name.
WORLDS: dict[str, Callable[[], Plan]] = {
    "room": room,
    "maze": maze,
    "warehouse": warehouse,
    "office": office,
    "arena": arena,
}
