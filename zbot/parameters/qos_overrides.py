"""QoS overrides by parameters, e.g. `-p qos_overrides./scan.subscription.depth:=1`."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

from zbot.errors import InvalidQoSProfileError
from zbot.parameters.errors import InvalidQosOverridesError
from zbot.parameters.store import Declaration
from zbot.parameters.validation import Descriptor
from zbot.qos import QoSPolicyEnum, QoSPolicyKind, QoSProfile
from zbot.time import Duration

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from typing_extensions import Self

    from zbot.parameters.store import ParameterStore


class QoSOverridingOptions:
    """Policies of a publisher or subscription that parameters may override.

    Args:
        policy_kinds: The policies. Each policy becomes a read-only parameter.
        callback: Function that checks the profile with the overrides. It returns a
            `SetParametersResult`.
        entity_id: Text that distinguishes two publishers or subscriptions of one topic.
    """

    policy_kinds: tuple[QoSPolicyKind, ...]
    callback: Callable[[QoSProfile], Any] | None
    entity_id: str | None

    def __init__(
        self,
        policy_kinds: Iterable[QoSPolicyKind],
        *,
        callback: Callable[[QoSProfile], Any] | None = None,
        entity_id: str | None = None,
    ) -> None:
        self.policy_kinds = tuple(policy_kinds)
        self.callback = callback
        self.entity_id = entity_id

    @classmethod
    def with_default_policies(
        cls,
        *,
        callback: Callable[[QoSProfile], Any] | None = None,
        entity_id: str | None = None,
    ) -> Self:
        """Return options for history, depth and reliability."""
        kinds = (QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY)
        return cls(kinds, callback=callback, entity_id=entity_id)


def overridden(
    store: ParameterStore, entity: str, topic: str, qos: QoSProfile, options: QoSOverridingOptions
) -> QoSProfile:
    """Declare the policies as parameters. Return a copy of the profile with the parameters' values.

    Args:
        store: The node's parameters.
        entity: `publisher` or `subscription`.
        topic: The topic's full name.
        qos: The program's profile, which gives the defaults of the parameters.
        options: The policies and the callback.

    Raises:
        UnknownQoSKeyError: An override is not a value of its policy.
        InvalidParameterTypeException: An override has another type.
        InvalidQosOverridesError: The options' callback rejects the result.
    """
    profile = copy.copy(qos)
    override(store, entity, topic, profile, options)
    return profile


def override(
    store: ParameterStore,
    entity: str,
    topic: str,
    profile: QoSProfile,
    options: QoSOverridingOptions,
) -> None:
    """Do the same as `overridden`, but change the profile itself."""
    suffix = "" if options.entity_id is None else f"_{options.entity_id}"
    for kind in options.policy_kinds:
        if kind is QoSPolicyKind.LIFESPAN and entity == "subscription":
            continue  # the publisher decides the lifespan of its messages
        policy = kind.name.lower()
        name = f"qos_overrides.{topic}.{entity}{suffix}.{policy}"
        if name not in store.values:
            about = Descriptor(description=f"{policy} of the {entity} of {topic}", read_only=True)
            store.declare([Declaration(name, policy_parameter(profile, kind), about)])
        _override(profile, policy, store.get(name).value)
    result = None if options.callback is None else options.callback(profile)
    if result is not None and not result.successful:
        raise InvalidQosOverridesError(f"the {entity} of {topic}", result.reason)


def policy_parameter(profile: QoSProfile, policy: QoSPolicyKind) -> str | int | bool:
    """Return a policy as the value of a parameter: a short key, a number, a bool or nanoseconds.

    Raises:
        InvalidQoSProfileError: The policy is unknown.
    """
    value: Any = getattr(profile, policy.name.lower())
    if isinstance(value, QoSPolicyEnum):
        if value.name == "UNKNOWN":
            raise InvalidQoSProfileError(f"the {policy.name.lower()} is UNKNOWN")
        return value.short_key
    return value.nanoseconds if isinstance(value, Duration) else value


def _override(profile: QoSProfile, policy: str, value: Any) -> None:
    present = getattr(profile, policy)
    if isinstance(present, QoSPolicyEnum):
        value = type(present).get_from_short_key(value)
    elif isinstance(present, Duration):
        value = Duration(nanoseconds=value)
    setattr(profile, policy, value)
