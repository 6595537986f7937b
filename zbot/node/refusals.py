"""Refusals of samples that a subscription cannot read, e.g. of another type."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.log import get_logger

if TYPE_CHECKING:
    import zenoh

    from zbot.wire.dialect import Dialect
    from zbot.wire.tokens import EndpointToken

# The largest number of reasons to log. A wrong program may cause a new reason with each message.
_MAX_REASONS = 3


class Refusals:
    """Decides which samples a subscription cannot read, counts them, and logs each reason once.

    Args:
        dialect: The format of keys and attachments.
        token: The subscription's token.
        logger_name: Name of the node's logger.
    """

    def __init__(self, dialect: Dialect, token: EndpointToken, logger_name: str) -> None:
        self.count = 0  #: messages that could not be decoded, or had another type
        self._dialect = dialect
        self._token = token
        self._logger_name = logger_name
        #: Whether the type of each message must be checked, not only of each publisher.
        self.checks_keys = dialect.refuses_keys(token)
        self._logged: set[str] = set()

    def reason_of_sample(self, sample: zenoh.Sample, facts: bytes | None) -> str:
        """Return why to refuse a sample that has no valid attachment, or an empty string."""
        length = None if facts is None else len(facts)
        return self._dialect.attachment_refusal(length) or self.reason_of_type(sample)

    def reason_of_type(self, sample: zenoh.Sample) -> str:
        """Return why a sample's type is wrong, or an empty string if it is right or unknown."""
        return self._dialect.refusal(sample.key_expr, sample.encoding, self._token.type_name)

    def add(self, reason: str) -> None:
        """Count a message that was refused. Log the reason if it is new."""
        self.count += 1
        if reason not in self._logged and len(self._logged) < _MAX_REASONS:
            self._logged.add(reason)
            get_logger(self._logger_name).error(
                f"{self._token.name}: cannot read a message: {reason} "
                "(more of this kind are only counted)"
            )
