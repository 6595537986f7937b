"""Decoder of a subscription's messages, with its content filter."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from zbot.errors import WrongStateError
from zbot.log import get_logger
from zbot.wire.errors import CodecError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.content_filter import ContentFilter
    from zbot.node.refusals import Refusals
    from zbot.wire.dialect import Dialect


class ContentFilterOptions(NamedTuple):
    """Content filter of a subscription, for `create_subscription`.

    `zbot.interfaces.content_filter` describes the expressions.
    """

    filter_expression: str  #: an empty expression selects every message
    expression_parameters: list[str]  #: values of `%0`, `%1` ..., written as in an expression


class MessageDecoder:
    """Decodes the payloads of a topic, and selects the messages that a filter accepts.

    Args:
        dialect: The format of the payloads.
        msg_type: Message class.
        topic: Full name of the topic.
        raw: Whether a message is bytes in ROS 2's CDR, or with `"payload"`, the bytes that were
            sent.
        refusals: The messages that cannot be read.
        logger_name: Name of the node's logger.
    """

    def __init__(
        self,
        dialect: Dialect,
        msg_type: type[Any],
        topic: str,
        *,
        raw: bool | Literal["payload"],
        refusals: Refusals,
        logger_name: str,
    ) -> None:
        codec = dialect.codec_for(msg_type)
        #: Returns what the callback takes. It raises a `CodecError` for values that are not valid.
        self.decode: Callable[[bytes], Any] = codec.decode_strictly
        self._read = codec.decode  # for values that are not valid, and for the filter
        if raw:
            self.decode = bytes if raw == "payload" else dialect.raw_decoder(msg_type)
        self.filter: ContentFilter | None = None
        self._raw = raw
        self._msg_type = msg_type
        self._topic = topic
        self._refusals = refusals
        self._logger_name = logger_name
        self._has_replacements = False  # whether a value that is not valid was logged

    def set_filter(self, expression: str, parameters: list[str]) -> None:
        """Accept only messages for which an expression is true. An empty one accepts all.

        Raises:
            ContentFilterError: The filter does not fit the message type. The old filter stays.
        """
        from zbot.interfaces.content_filter import ContentFilter  # noqa: PLC0415 - rarely needed

        new = None
        if expression.strip():
            new = ContentFilter(expression, parameters, self._msg_type)
        self.filter = new
        self._filter_options = ContentFilterOptions(expression, list(parameters))

    @property
    def filter_options(self) -> ContentFilterOptions:
        """The expression of the filter.

        Raises:
            WrongStateError: There is no filter.
        """
        if self.filter is None:
            raise WrongStateError(f"the subscription of {self._topic} has no content filter")
        return self._filter_options

    def accepts(self, payload: bytes, message: Any = None) -> bool:
        """Return whether the content filter selects a message. Without a filter, return true.

        Args:
            payload: The message's payload.
            message: What `decode` returned. If it is left out, the payload is decoded here.
        """
        if self.filter is None:
            return True
        try:
            is_decoded = message is not None and not self._raw
            return self.filter.matches(message if is_decoded else self._read(payload))
        except CodecError as exc:
            self._refusals.add(str(exc))  # a raw message is decoded here for the first time
            return False

    def replaced(self, payload: bytes, error: CodecError) -> Any:
        """Return a message in which values are not valid, e.g. a text that is not UTF-8.

        Return `None` if the message cannot be decoded at all, or if the callback takes bytes.
        """
        if self._raw:
            return None
        try:
            message = self._read(payload)
        except CodecError:
            return None
        if not self._has_replacements:
            self._has_replacements = True
            get_logger(self._logger_name).warning(
                f"{self._topic}: {error.replacement()} (this is logged only once)"
            )
        return message

    def replaced_or_refused(self, payload: bytes, error: CodecError) -> Any:
        """Return the same as `replaced`. If it is `None`, count and log the message as refused."""
        message = self.replaced(payload, error)
        if message is None:
            self._refusals.add(str(error))
        return message
