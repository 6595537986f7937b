"""Base class of displays whose messages stay in the scene for some time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from zbot.view.displays.display import Display, Setting, item

if TYPE_CHECKING:
    from zbot.view.displays.display import Value
    from zbot.view.mesh_file import MeshFiles

DECAY = "decay time"
#: Of a display: seconds for which a message is shown. 0 means until the next message.
DECAY_SETTING = Setting(DECAY, 0.0, low=0.0, high=30.0, step=0.1)
_MOST_MESSAGES = 300


class Decaying(Display):
    """Display whose messages stay for the setting `decay time`, each where it was measured."""

    stays: ClassVar[bool] = True

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        self._ends_ns: dict[str, int] = {}
        self._count = 0

    def take(self, message: Any) -> None:
        """Show a message, beside the earlier ones if they stay."""
        if not self.number(DECAY):
            super().take(message)
            return
        self.notice = ""
        made = item(message.header, self.shapes(message))
        self._count += 1
        self.items[str(self._count)] = made
        if len(self.items) > _MOST_MESSAGES:
            self.notice = f"only the last {_MOST_MESSAGES} messages are shown"
            self._remove(next(iter(self.items)))

    def tick(self, now_ns: int) -> None:
        """Remove messages whose time is over."""
        decay_ns = int(self.number(DECAY) * 1e9)
        if not decay_ns:
            return
        for name in list(self.items):
            if self._ends_ns.setdefault(name, now_ns + decay_ns) <= now_ns:
                self._remove(name)

    def change(self, name: str, value: Value) -> None:
        """Change a setting. Only the newest message is drawn again with it."""
        super().change(name, value)
        self.items.clear()
        self._ends_ns.clear()

    def _remove(self, name: str) -> None:
        del self.items[name]
        self._ends_ns.pop(name, None)
