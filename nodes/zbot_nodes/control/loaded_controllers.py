"""Controllers that a controller manager has loaded, with the switch that activates them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot_nodes.control import chain
from zbot_nodes.control.controller import Controller, ControllerError, State

if TYPE_CHECKING:
    from zbot.log.logger import Logger
    from zbot_nodes.control.hardware import SimulatedHardware


class LoadedControllers:
    """Controllers of one controller manager.

    Args:
        hardware: The hardware that the controllers read and command.
        logger: The logger of the manager.

    Attributes:
        by_name: The controllers by name.
        active: The active controllers, in the order of their updates.
    """

    def __init__(self, hardware: SimulatedHardware, logger: Logger) -> None:
        self.by_name: dict[str, Controller] = {}
        self.active: list[Controller] = []
        self.hardware, self.logger = hardware, logger

    def known(self, name: str) -> Controller:
        """Return a controller that is loaded."""
        if name not in self.by_name:
            raise ControllerError(f"Could not find controller with name '{name}'")
        return self.by_name[name]

    def switch(self, begin: list[str], end: list[str], *, is_strict: bool) -> None:
        """Activate and deactivate controllers.

        Raises:
            ControllerError: The switch is strict, and a controller cannot be activated or
                deactivated. Then nothing changes.
        """
        starting: list[Controller] = []
        stopping: list[Controller] = []
        for names, found, check in ((end, stopping, self._stops), (begin, starting, self._starts)):
            for name in names:
                try:
                    check(name, stopping, starting)
                except ControllerError as error:
                    self._refuse(str(error), is_strict=is_strict)
                else:
                    found.append(self.by_name[name])
        self._keep_chains(starting, stopping, is_strict=is_strict)
        for controller in stopping:
            controller.deactivate()
            controller.state = State.INACTIVE
            self.logger.info(f"Deactivated controller '{controller.get_name()}'")
        for controller in starting:
            self._activate(controller)
            controller.state = State.ACTIVE
            self.logger.info(f"Activated controller '{controller.get_name()}'")
        active = [
            controller for controller in self.by_name.values() if controller.state is State.ACTIVE
        ]
        self.active = chain.in_order(active)
        self._connect_chains()

    def _refuse(self, reason: str, *, is_strict: bool) -> None:
        """Refuse the whole switch if it is strict. Otherwise only warn."""
        if is_strict:
            raise ControllerError(reason)
        self.logger.warn(reason)

    def _stops(self, name: str, _stopping: list[Controller], _starting: list[Controller]) -> None:
        """Check that a controller can be deactivated."""
        if self.known(name).state is not State.ACTIVE:
            raise ControllerError(f"Controller '{name}' can not be deactivated: it is not active")

    def _starts(self, name: str, stopping: list[Controller], starting: list[Controller]) -> None:
        """Check that a controller can be activated with others, after some have stopped."""
        controller = self.known(name)
        if controller.state is not State.INACTIVE and controller not in stopping:
            raise ControllerError(
                f"Controller '{name}' can not be activated from its state {controller.state.value}"
            )
        missing = [
            *(set(controller.command_interfaces()) - set(self.hardware.commands)),
            *(set(controller.state_interfaces()) - set(self.hardware.states)),
        ]
        if missing:
            raise ControllerError(
                f"Controller '{name}' needs the interface '{min(missing)}', which neither the "
                "hardware nor another configured controller has"
            )
        needed = {*controller.command_interfaces(), *controller.state_interfaces()}
        closed = {name: owner for name, owner in self.hardware.closed().items() if name in needed}
        if closed:
            raise ControllerError(
                f"Controller '{name}' needs the interface '{min(closed)}', but the hardware "
                f"'{closed[min(closed)]}' is not configured"
            )
        others = [other for other in self.active if other not in stopping] + starting
        taken = {name for other in others for name in other.command_interfaces()}
        taken &= set(controller.command_interfaces())
        if taken:
            raise ControllerError(
                f"Controller '{name}' can not be activated: another controller commands "
                f"'{min(taken)}'"
            )

    def _keep_chains(
        self, starting: list[Controller], stopping: list[Controller], *, is_strict: bool
    ) -> None:
        """Leave out controllers that would break a chain.

        Raises:
            ControllerError: The switch is strict, and would break a chain.
        """
        while True:
            active = [
                controller for controller in self.active if controller not in stopping
            ] + starting
            broken = chain.broken_link(self.by_name.values(), active)
            if broken is None:
                return
            self._refuse(broken.reason(starting), is_strict=is_strict)
            if broken.user in starting:
                starting.remove(broken.user)
            else:
                stopping.remove(broken.provider)

    def _connect_chains(self) -> None:
        """Tell controllers whether another controller commands them from now on."""
        claimed = self.claimed()
        for controller in self.by_name.values():
            is_chained = controller in self.active and not claimed.isdisjoint(
                controller.reference_interfaces()
            )
            if is_chained != controller.is_chained:
                controller.is_chained = is_chained
                if controller in self.active:
                    self._activate(controller)

    def _activate(self, controller: Controller) -> None:
        """Forget a controller's references, and prepare its first update."""
        references = controller.reference_interfaces()
        self.hardware.commands.update(dict.fromkeys(references, math.nan))
        controller.activate()

    def unused_references(self) -> set[str]:
        """Return the references that no controller commands now."""
        ready = (
            controller
            for controller in self.by_name.values()
            if controller.state is not State.UNCONFIGURED
        )
        return {
            name
            for controller in ready
            if not controller.is_chained
            for name in controller.reference_interfaces()
        }

    def claimed(self) -> set[str]:
        """Return the command interfaces of the active controllers."""
        return {name for controller in self.active for name in controller.command_interfaces()}
