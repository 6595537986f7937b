"""Managed node and managed entity whose calls the tests see."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import pytest

from zbot.lifecycle import LifecycleNode, LifecycleState, SimpleManagedEntity
from zbot.lifecycle import TransitionCallbackReturn as Outcome

if TYPE_CHECKING:
    from tests.conftest import MakeContext


class Robot(LifecycleNode):
    """Managed node whose callbacks run functions of the test, or else the default."""

    def __init__(self, **options: Any) -> None:
        super().__init__("robot", **options)
        self.plan: dict[str, Any] = {}
        self.calls: list[tuple[str, str]] = []

    def _do(self, name: str, state: LifecycleState) -> Outcome:
        self.calls.append((name, state.label))
        planned = self.plan.get(name, Outcome.SUCCESS)
        if isinstance(planned, Exception):
            raise planned
        return cast("Outcome", planned() if callable(planned) else planned)

    def on_configure(self, state: LifecycleState) -> Outcome:
        super().on_configure(state)
        return self._do("configure", state)

    def on_activate(self, state: LifecycleState) -> Outcome:
        super().on_activate(state)
        return self._do("activate", state)

    def on_deactivate(self, state: LifecycleState) -> Outcome:
        return self._do("deactivate", state)

    def on_cleanup(self, state: LifecycleState) -> Outcome:
        return self._do("cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> Outcome:
        return self._do("shutdown", state)

    def on_error(self, state: LifecycleState) -> Outcome:
        return self._do("error", state)

    @property
    def label(self) -> str:
        return self._state_machine.current_state[1]


@pytest.fixture
def robot(make_context: MakeContext) -> Robot:
    return Robot(context=make_context())


class Motor(SimpleManagedEntity):
    def __init__(self) -> None:
        super().__init__()
        self.turns = 0
        self.refusals = 0

    @SimpleManagedEntity.when_enabled
    def turn(self, count: int) -> int:
        self.turns += count
        return self.turns
