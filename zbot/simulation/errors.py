"""Errors of the simulator."""

from __future__ import annotations

from zbot.errors import ZbotError


class SimulationError(ZbotError, ValueError):
    """A world, a robot or a request cannot be simulated."""
