"""Chain of controllers: a controller commands the references of another controller."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot_nodes.control.controller import State

from controller_manager_msgs.msg import ChainConnection

if TYPE_CHECKING:
    from collections.abc import Collection

    from zbot_nodes.control.controller import Controller


@dataclass(frozen=True)
class Link:
    """Controller that uses interfaces of another controller, the provider."""

    user: Controller
    provider: Controller
    interfaces: tuple[str, ...]

    def reason(self, starting: Collection[Controller]) -> str:
        """Return why the user cannot start, or why the provider cannot stop."""
        user, provider = self.user.get_name(), self.provider.get_name()
        if self.user in starting:
            return (
                f"Controller '{user}' can not be activated: it uses '{self.interfaces[0]}', but "
                f"'{provider}' is not active"
            )
        return (
            f"Controller '{provider}' can not be deactivated: the active controller '{user}' uses "
            f"'{self.interfaces[0]}'"
        )

    def message(self) -> ChainConnection:
        """Return the link as a part of the user's message."""
        start = f"{self.provider.get_name()}/"
        names = [name.removeprefix(start) for name in self.interfaces]
        return ChainConnection(name=self.provider.get_name(), reference_interfaces=names)


def links(controllers: Collection[Controller]) -> list[Link]:
    """Return the links between controllers. Controllers that are not configured have none."""
    ready = [controller for controller in controllers if controller.state is not State.UNCONFIGURED]
    found = []
    for user in ready:
        used = dict.fromkeys([*user.command_interfaces(), *user.state_interfaces()])
        for provider in ready:
            own = {*provider.reference_interfaces(), *provider.exported_interfaces()}
            shared = tuple(interface for interface in used if interface in own)
            if shared:
                found.append(Link(user, provider, shared))
    return found


def broken_link(controllers: Collection[Controller], active: Collection[Controller]) -> Link | None:
    """Return a link whose user is to be active, but whose provider is not."""
    found = links(controllers)
    return next(
        (link for link in found if link.user in active and link.provider not in active), None
    )


def in_order(active: Collection[Controller]) -> list[Controller]:
    """Return controllers in the order of their updates: each one before those that it commands."""
    found: list[Controller] = []
    seen: set[Controller] = set()
    existing = links(active)

    def add(controller: Controller) -> None:
        if controller not in seen:
            seen.add(controller)
            for link in existing:
                if link.provider is controller:
                    add(link.user)
            found.append(controller)

    for controller in active:
        add(controller)
    return found
