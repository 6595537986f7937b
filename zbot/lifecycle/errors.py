"""Errors in the code of managed nodes."""

from __future__ import annotations

from zbot.errors import ZbotError


class NotANodeError(ZbotError, RuntimeError):
    """`LifecycleNodeMixin` was used in a class that is not a `Node`."""

    def __init__(self, kind: type) -> None:
        self.kind = kind
        super().__init__(
            f"{kind.__name__} is not a node: LifecycleNodeMixin needs Node among the base classes, "
            "and Node's constructor must be called first"
        )


class NotAManagedEntityError(ZbotError, TypeError):
    """An object that is not a `ManagedEntity` was added to a managed node."""

    def __init__(self, entity: object) -> None:
        self.entity = entity
        super().__init__(
            f"{entity!r} cannot be managed: it must be a zbot.lifecycle.ManagedEntity, such as a "
            "publisher made by create_lifecycle_publisher()"
        )


class CallbackReturnError(ZbotError, TypeError):
    """A callback of a managed node returned a value that is not a `TransitionCallbackReturn`."""

    def __init__(self, owner: object, callback: str, outcome: object) -> None:
        self.owner, self.callback, self.outcome = owner, callback, outcome
        super().__init__(
            f"{type(owner).__name__}.{callback}() must return TransitionCallbackReturn.SUCCESS, "
            f"FAILURE or ERROR, not {outcome!r}"
        )
