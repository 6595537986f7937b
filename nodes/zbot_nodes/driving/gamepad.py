"""Gamepads of this machine, read with the optional library pygame, which uses SDL."""

from __future__ import annotations

import os
from typing import Any, Protocol

from zbot.errors.installation import pip_install


class Gamepad(Protocol):
    """State of a gamepad. Axes are from -1 to 1, left and up are positive; a button is 0 or 1."""

    name: str

    def read(self) -> tuple[list[float], list[int]]:
        """Return all axes and all buttons."""
        ...

    def rumble(self, intensity: float, seconds: float) -> None:
        """Shake with an intensity from 0 to 1. A gamepad that cannot shake does nothing."""
        ...

    @property
    def is_attached(self) -> bool:
        """Whether the gamepad is still connected."""
        ...


class _SdlGamepad:
    """Gamepad that SDL has opened."""

    def __init__(self, pygame: Any, joystick: Any) -> None:
        self._pygame, self._joystick = pygame, joystick
        self.name = str(joystick.get_name())
        # SDL reports the position of a trigger only after the trigger has moved for the first time.

    def read(self) -> tuple[list[float], list[int]]:
        """Return all axes, then two axes for each hat, and all buttons."""
        self._pygame.event.pump()
        stick = self._joystick
        # Left and up are negative in SDL, and positive in ROS 2.
        axes = [-stick.get_axis(number) for number in range(stick.get_numaxes())]
        for number in range(stick.get_numhats()):
            right, up = stick.get_hat(number)
            axes += [-float(right), float(up)]
        return axes, [stick.get_button(number) for number in range(stick.get_numbuttons())]

    def rumble(self, intensity: float, seconds: float) -> None:
        """Shake, if the gamepad can."""
        self._joystick.rumble(intensity, intensity, round(seconds * 1000))

    @property
    def is_attached(self) -> bool:
        """Whether SDL still lists the gamepad."""
        joystick = self._pygame.joystick
        present = [
            joystick.Joystick(index).get_instance_id() for index in range(joystick.get_count())
        ]
        return self._joystick.get_instance_id() in present


def missing_text() -> str:
    """Return the sentence that pygame is not installed."""
    return f"no gamepad can be read without pygame: {pip_install('zbot[gamepad]')}"


def find_gamepad(number: int = 0, name: str = "") -> Gamepad | None:
    """Return the gamepad with a name, or with a number if `name` is empty.

    Return `None` if the gamepad is not connected.

    Raises:
        ModuleNotFoundError: pygame is not installed.
    """
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")  # no window is opened
    os.environ.setdefault("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1")
    import pygame  # noqa: PLC0415  # pyright: ignore[reportMissingImports] - an extra

    if not pygame.joystick.get_init():
        pygame.display.init()  # `event.pump()` needs the display
        pygame.joystick.init()
    pygame.event.pump()
    for index in range(pygame.joystick.get_count()):
        joystick = pygame.joystick.Joystick(index)
        if (joystick.get_name() == name) if name else index == number:
            return _SdlGamepad(pygame, joystick)
    return None


def without_deadzone(value: float, deadzone: float) -> float:
    """Return an axis that is 0 near the centre, and from -1 to 1 outside of the dead zone."""
    if abs(value) <= deadzone or deadzone >= 1:
        return 0.0
    beyond = (abs(value) - deadzone) / (1 - deadzone)
    return min(1.0, beyond) * (1 if value > 0 else -1)
