"""Options for quality of service."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
)
from zbot.remote.profiles import profile_to_subscribe
from zbot.time import Duration

if TYPE_CHECKING:
    from zbot.wire.tokens import EndpointToken

_POLICIES: dict[str, Any] = {
    "history": HistoryPolicy,
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
}


def _option(words: str, text: str) -> Any:
    return typer.Option(f"--qos-{words}", help=text, rich_help_panel="Quality of service")


@dataclass(frozen=True)
class QosOptions:
    """Group of the `--qos-...` options. An option that is not given is `None`."""

    profile: Annotated[str | None, _option("profile", "Preset; the other options change it")] = None
    depth: Annotated[int | None, _option("depth", "Messages to keep")] = None
    history: Annotated[str | None, _option("history", "keep_last or keep_all")] = None
    reliability: Annotated[str | None, _option("reliability", "reliable or best_effort")] = None
    durability: Annotated[str | None, _option("durability", "volatile or transient_local")] = None
    liveliness: Annotated[str | None, _option("liveliness", "automatic or manual_by_topic")] = None
    lease_s: Annotated[
        float | None,
        _option("liveliness-lease-duration-seconds", "Seconds of the liveliness lease"),
    ] = None

    def to_publish(self) -> QoSProfile:
        """Return the profile for a publisher: the default profile, changed by the options."""
        return self._build(self._preset("default"))

    def to_subscribe(self, publishers: list[EndpointToken]) -> QoSProfile:
        """Return the profile for a subscription.

        Without `--qos-profile`, the profile fits all publishers. Other options override it.
        """
        profile = self._preset("sensor_data")
        if self.profile is None:
            profile_to_subscribe([end.qos for end in publishers], profile)
        return self._build(profile)

    def _preset(self, default: str) -> QoSProfile:
        name = self.profile or default
        keys = QoSPresetProfiles.short_keys()
        if name not in {*keys, "best_available", "unknown"}:
            raise typer.BadParameter(f"no profile {name!r}; choose from {', '.join(sorted(keys))}")
        found = QoSPresetProfiles.get_from_short_key(name if name in keys else default)
        return QoSProfile(
            history=found.history,
            depth=found.depth,
            reliability=found.reliability,
            durability=found.durability,
            lifespan=found.lifespan,
            deadline=found.deadline,
            liveliness=found.liveliness,
            liveliness_lease_duration=found.liveliness_lease_duration,
        )

    def _build(self, profile: QoSProfile) -> QoSProfile:
        for name, policy in _POLICIES.items():
            word = getattr(self, name)
            if word is not None:
                setattr(profile, name, _policy(name, policy, word))
        if self.depth is not None:
            profile.depth = self.depth
        if self.lease_s is not None:
            profile.liveliness_lease_duration = Duration(seconds=self.lease_s)
        if profile.durability is DurabilityPolicy.TRANSIENT_LOCAL and profile.depth == 0:
            profile.depth = 1
        return profile


DEFAULT_QOS: Final = QosOptions()


def _policy(name: str, policy: Any, word: str) -> Any:
    if word not in policy.short_keys():
        known = ", ".join(policy.short_keys())
        raise typer.BadParameter(f"--qos-{name} cannot be {word!r}; choose from {known}")
    return policy(policy.get_from_short_key(word))
