"""Limits of a speed, of its acceleration and of its jerk."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class SpeedLimiter:
    """Limits in m/s, m/s² and m/s³, or in rad/s, rad/s² and rad/s³. NaN means no limit."""

    min_velocity: float = math.nan
    max_velocity: float = math.nan
    max_acceleration: float = math.nan
    max_deceleration: float = math.nan  #: negative
    max_acceleration_reverse: float = math.nan  #: negative
    max_deceleration_reverse: float = math.nan
    max_jerk: float = math.nan
    min_jerk: float = math.nan  #: negative

    def limited(self, speed: float, before: float, earlier: float, period_s: float) -> float:
        """Return the allowed speed.

        Args:
            speed: The wanted speed.
            before: The speed of the last period.
            earlier: The speed of the period before the last period.
            period_s: Length of a period.
        """
        change = before - earlier
        jerk_s2 = period_s * period_s
        low_jerk = self.min_jerk if not math.isnan(self.min_jerk) else -self.max_jerk
        wanted = _clamp(speed - before - change, low_jerk * jerk_s2, self.max_jerk * jerk_s2)
        low, high = self._accelerations(before)
        step = _clamp(wanted + change, low * period_s, high * period_s)
        slowest = self.min_velocity if not math.isnan(self.min_velocity) else -self.max_velocity
        return _clamp(before + step, slowest, self.max_velocity)

    def _accelerations(self, before: float) -> tuple[float, float]:
        """Return the lowest and the highest acceleration. Braking and driving differ."""
        forward = self.max_acceleration
        reverse = _or(self.max_acceleration_reverse, -forward)
        if before > 0:
            return _or(self.max_deceleration, -forward), forward
        if before < 0:
            return reverse, _or(self.max_deceleration_reverse, -_or(self.max_deceleration, reverse))
        return reverse, forward


def _or(value: float, otherwise: float) -> float:
    return otherwise if math.isnan(value) else value


def _clamp(value: float, low: float, high: float) -> float:
    value = value if math.isnan(high) else min(value, high)
    return value if math.isnan(low) else max(value, low)
