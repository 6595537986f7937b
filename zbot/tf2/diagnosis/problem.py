"""Problems of transforms, each with a cause, a sentence and what to type."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum


class Cause(str, Enum):
    """Reason why transforms are missing or wrong."""

    NO_PUBLISHER = "no publisher"
    SILENT_PUBLISHER = "silent publisher"
    UNKNOWN_FRAME = "unknown frame"
    WRONG_NAME = "wrong name"
    LEADING_SLASH = "leading slash"
    TWO_TREES = "two trees"
    TWO_PARENTS = "two parents"
    LOOP = "loop"
    NAMESPACE = "namespace"
    STALE = "stale"
    STATIC_ON_TF = "static on /tf"
    MOVING_ON_TF_STATIC = "moving on /tf_static"
    SEVERAL_PUBLISHERS = "several publishers"
    CLOCK_AHEAD = "clock ahead"
    CLOCK_BEHIND = "clock behind"
    STAMPED_AHEAD = "stamped ahead"
    MIXED_TIME = "mixed time"
    FUTURE = "extrapolation into the future"
    PAST = "extrapolation into the past"


@dataclass(frozen=True)
class Problem:
    """Problem of one or several frames."""

    cause: Cause
    text: str  #: one sentence without a full stop, with the names of the frames
    advice: str  #: what to do or to type
    frames: tuple[str, ...]
    is_warning: bool = False  #: transforms are found nevertheless

    def __str__(self) -> str:
        """Return two lines: the sentence, and what to do."""
        return f"{self.text}\n  -> {self.advice}"

    def for_transform(self, target: str, source: str) -> Problem:
        """Return the problem as the reason why one transform is missing, or is not reliable."""
        what = f"no transform from {source or repr(source)} to {target or repr(target)}"
        if self.is_warning:
            what = f"the transform from {source} to {target} is not reliable"
        return replace(self, text=f"{what}: {self.text}")


def duration_text(nanoseconds: float) -> str:
    """Return a duration in the unit that reads best, e.g. `80 ms`, `0.4 s` or `3 days`."""
    seconds = abs(nanoseconds) / 1e9
    units = ((0.1, 1e-3, "ms"), (120, 1, "s"), (7200, 60, "minutes"), (172800, 3600, "hours"))
    for limit, unit, name in units:
        if seconds < limit:
            digits = 0 if seconds / unit >= 10 else 1
            return f"{seconds / unit:.{digits}f} {name}"
    return f"{seconds / 86400:.0f} days"
