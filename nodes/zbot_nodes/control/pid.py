"""PID: a command that brings a measured value to a wanted value."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot_nodes.control.controller import ControllerError

if TYPE_CHECKING:
    from zbot_nodes.control.controller import Controller

_STRATEGIES = ("none", "conditional_integration", "back_calculation")


@dataclass
class Pid:
    """Gains and limits of a PID, and its integral part."""

    p: float = 0.0
    i: float = 0.0
    d: float = 0.0
    feedforward: float = 0.0  #: factor of the wanted value, which is added to the command
    i_clamp_min: float = -math.inf  #: limits of the integral part
    i_clamp_max: float = math.inf
    u_clamp_min: float = -math.inf  #: limits of the command without feedforward
    u_clamp_max: float = math.inf
    error_deadband: float = 0.0  #: smaller errors do not change the integral part
    tracking_time_constant: float = 0.0  #: for back calculation, in s; 0: from the gains
    antiwindup_strategy: str = "none"  #: what the integral part does while a command is limited
    angle_wraparound: bool = False  #: whether a value is an angle that is equal after a turn
    integral: float = 0.0
    last_error: float = math.nan

    def reset(self) -> None:
        """Forget the last error. The integral part stays, as in ROS 2."""
        self.last_error = math.nan

    def error(self, wanted: float, measured: float) -> float:
        """Return the difference of two values. For angles, it is between -pi and pi."""
        difference = wanted - measured
        return math.remainder(difference, math.tau) if self.angle_wraparound else difference

    def command(
        self, error: float, period_s: float, *, rate: float | None = None, wanted: float = 0.0
    ) -> float:
        """Return the command for a period.

        Args:
            error: The wanted value minus the measured value.
            period_s: Length of the period, above 0.
            rate: Change of the error per second. Without it, the last error is used.
            wanted: The value for the feedforward.
        """
        if rate is None:
            rate = 0.0 if math.isnan(self.last_error) else (error - self.last_error) / period_s
        self.last_error = error
        direct = self.p * error + self.d * rate
        if abs(error) > self.error_deadband:
            step = self._step(error, direct + self.integral, period_s)
            integral = self.integral + step
            self.integral = min(max(integral, self.i_clamp_min), self.i_clamp_max)
        return self._limited(direct + self.integral) + self.feedforward * wanted

    def _limited(self, command: float) -> float:
        return min(max(command, self.u_clamp_min), self.u_clamp_max)

    def _step(self, error: float, command: float, period_s: float) -> float:
        """Return the change of the integral part."""
        step, excess = self.i * error * period_s, command - self._limited(command)
        if self.antiwindup_strategy == "conditional_integration" and excess * error > 0:
            return 0.0
        if self.antiwindup_strategy == "back_calculation" and self.i > 0:
            default_s = math.sqrt(self.d / self.i) if self.d > 0 else self.p / self.i
            time_s = self.tracking_time_constant or default_s
            return step - (excess * period_s / time_s if time_s > 0 else 0.0)
        return step


_NUMBERS = (
    *("p", "i", "d", "i_clamp_min", "i_clamp_max", "u_clamp_min", "u_clamp_max"),
    *("error_deadband", "tracking_time_constant"),
)


def read_pid(controller: Controller, name: str, feedforward: str) -> Pid:
    """Return a PID with the parameters of a controller.

    Args:
        controller: The controller.
        name: The name before those of the gains, e.g. `gains.left_wheel`.
        feedforward: The name of the gain of the feedforward.

    Raises:
        ControllerError: A parameter cannot be used.
    """
    pid = Pid(feedforward=controller.number(f"{name}.{feedforward}", 0.0))
    for key in _NUMBERS:
        setattr(pid, key, controller.number(f"{name}.{key}", getattr(pid, key)))
    pid.angle_wraparound = bool(controller.setting(f"{name}.angle_wraparound", False))
    strategy = str(controller.setting(f"{name}.antiwindup_strategy", pid.antiwindup_strategy))
    if strategy not in _STRATEGIES:
        raise ControllerError(
            f"the parameter {name}.antiwindup_strategy of {controller.get_name()} is "
            f"'{strategy}': write one of {', '.join(_STRATEGIES)}"
        )
    pid.antiwindup_strategy = strategy
    return pid
