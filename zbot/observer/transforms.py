"""Watch of all transforms for one page."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from zbot.observer.shared_entities import EntityReference
    from zbot.observer.system import System
    from zbot.tf2.diagnosis import Diagnosis, TransformMonitor


class TransformWatch:
    """Watch of all transforms. All watches of a system share the subscriptions.

    After a pause of all watches, the diagnosis is a new one, because it has missed transforms.

    Args:
        system: The system.
        is_active: Whether the watch hears transforms at first, without a call of `resume`.
    """

    def __init__(self, system: System, *, is_active: bool) -> None:
        self._system = system
        self._reference: EntityReference[TransformMonitor] | None = None
        if is_active:
            self.resume()

    @property
    def diagnosis(self) -> Diagnosis | None:
        """What was heard, or None during a pause."""
        return None if self._reference is None else self._reference.entity.diagnosis

    @property
    def has_listened(self) -> bool:
        """Whether transforms have had a second to come, so that missing ones are missing."""
        return self._reference is not None and self._reference.entity.has_listened

    def resume(self) -> None:
        """Hear transforms. A second call does nothing."""
        if self._reference is None:
            self._reference = self._system.transforms()

    def pause(self) -> None:
        """Stop to hear transforms. A second call does nothing."""
        reference, self._reference = self._reference, None
        if reference is not None:
            reference.release()

    def release(self) -> None:
        """End the watch."""
        self.pause()
