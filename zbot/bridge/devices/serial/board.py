"""Board on a serial port: the loop that publishes its lines, also after it was unplugged."""

from __future__ import annotations

import threading
import time
from collections import deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.bridge.devices.errors import DeviceError, UnreadableError
from zbot.bridge.devices.message_maker import text_of
from zbot.bridge.devices.serial import port as ports
from zbot.bridge.devices.serial.line import LineReader
from zbot.bridge.devices.serial.line_buffer import LineBuffer
from zbot.bridge.devices.serial.lost_bytes import lost_bytes
from zbot.bridge.devices.tally import Tally
from zbot.bridge.devices.topic_publishers import TopicPublishers
from zbot.bridge.devices.topic_subscriptions import Received, TopicSubscriptions, Wanted
from zbot.bridge.devices.topic_type import TypeTable
from zbot.errors import counted
from zbot.text.terminal import single_line
from zbot.threads.background_thread import background_thread
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from zbot.bridge.devices.serial.port import PortInfo
    from zbot.node.node import Node

_REPORT_S = 10.0
_SEARCH_S = 0.3
_SILENCE_S = 5.0
#: A line whose bytes come earlier after the port was opened may lack its first part.
_WHOLE_AFTER_S = 0.05
_WAITING_LINES = 100
_SHOWN_LINES = 10  #: texts in a second that become log lines
_SHOWN_CHARACTERS = 200


@dataclass(frozen=True)
class BoardOptions:
    """What the user asks for."""

    baud: int = 115200
    topic: str = ""  #: topic of lines that are only a value
    names: tuple[str, ...] = ()  #: topics of lines that are only numbers
    types: TypeTable = field(default_factory=TypeTable)
    to_board: tuple[Wanted, ...] = ()  #: topics whose messages the board gets


class Board:
    """A board. `run` works until Ctrl-C or SIGTERM.

    Args:
        node: The node that stands for the board.
        info: The port.
        is_found: Whether the port was found without its name. Then the board may come back under
            another name.
        options: What the user asks for.
    """

    def __init__(
        self, node: Node, info: PortInfo, options: BoardOptions, *, is_found: bool = False
    ) -> None:
        self._node, self._info, self._is_found, self._options = node, info, is_found, options
        self._log = node.get_logger()
        self.tally = Tally(self._log, "line")
        self._subscriptions: TopicSubscriptions | None = None
        self._topics = TopicPublishers(node, options.types, self.tally, self._is_taken)
        self._reader = LineReader(options.topic, options.names, self._topics.type_of)
        self._to_board: deque[bytes] = deque()
        self._has_lines = threading.Condition()
        self._port: Any = None
        self._shown_in = (0, 0)

    def run(self, opened: Any) -> None:
        """Publish the lines of the board until Ctrl-C or SIGTERM.

        Args:
            opened: The open port.
        """
        self._subscriptions = TopicSubscriptions(
            self._node,
            self._options.to_board,
            self._send,
            lambda: self._topics.names,
            self.tally,
        )
        try:
            with background_thread("zbot serial writer", self._write):
                while opened is not None:
                    self._read(opened)
                    opened = self._reopened()
        finally:
            self._log.info(self.tally.summary())

    # -- from the board ------------------------------------------------------------------------

    def _read(self, opened: Any) -> None:
        """Publish until the board is unplugged or the program ends."""
        buffer = LineBuffer()
        try:
            self._begin(opened, buffer)
            self._read_lines(opened, buffer)
        except OSError as error:
            self._log.warning(f"{self._info.device} was unplugged: waiting until it is back")
            self._log.debug(str(error))
        finally:
            with self._has_lines:
                self._port = None
            if len(buffer):
                self.tally.lose("the line had no end")
            opened.close()

    def _begin(self, opened: Any, buffer: LineBuffer) -> None:
        """Skip the line that the board is printing, and let lines go to the board."""
        opened.timeout = _WHOLE_AFTER_S
        begun = opened.read(1)
        opened.timeout = ports.READ_TIMEOUT_S
        if begun and begun != b"\n":
            buffer.skip_line()
            self.tally.lose("the line had begun before the port was open", is_usual=True)
        with self._has_lines:
            self._to_board.clear()  # a command of before may be dangerous now
            self._port = opened
        name = f" ({self._info.description})" if self._info.description else ""
        self._log.info(f"{self._info.device}{name} is open at {self._options.baud} baud")

    def _read_lines(self, opened: Any, buffer: LineBuffer) -> None:
        hint_time, report_time = Deadline(_SILENCE_S), Deadline(_REPORT_S)
        lost = lost_bytes(opened)
        while self._node.context.ok():
            data = opened.read(max(1, opened.in_waiting))
            if data:
                self._take(buffer, data)
            if hint_time.is_over:
                hint_time = Deadline(None)
                self._hint(buffer)
            if report_time.is_over:
                report_time, before, lost = Deadline(_REPORT_S), lost, lost_bytes(opened)
                if lost > before:
                    self.tally.lose("the port was full", count=lost - before)
                self.tally.report()

    def _take(self, buffer: LineBuffer, data: bytes) -> None:
        long_before = buffer.too_long
        for line in buffer.feed(data):
            self._publish(line)
        if buffer.too_long > long_before:
            self.tally.lose("the line is too long", advice="a line ends with println()")

    def _publish(self, line: bytes) -> None:
        try:
            text = line.decode().strip()
        except UnicodeDecodeError:
            text = "\0"
        if not text:
            return
        self.tally.received += 1
        if not text.replace("\t", " ").isprintable():
            self._lose_garbage(line)
            return
        try:
            readings = self._reader.read(text)
        except UnreadableError as error:
            self.tally.lose(error.reason, f"{text}; {error.detail}", error.hint)
            return
        for reading in readings:
            self._topics.publish(*reading)
        if not readings:
            self._show(text)

    def _is_taken(self, topic: str) -> bool:
        return self._subscriptions is not None and self._subscriptions.takes(topic)

    def _lose_garbage(self, line: bytes) -> None:
        advice = (
            f"the number in the board's Serial.begin(...) must be {self._options.baud}, or type "
            "--baud and that number"
        )
        self.tally.lose("it is not text", repr(line[:20]), advice)

    def _show(self, text: str) -> None:
        """Write a text that is no value as a log line. Count it if there are too many."""
        second = int(time.monotonic())
        self._shown_in = (second, self._shown_in[1] + 1 if self._shown_in[0] == second else 1)
        if self._shown_in[1] > _SHOWN_LINES:
            self.tally.lose(f"more than {_SHOWN_LINES} lines of text in a second", text)
            return
        self.tally.shown += 1
        self._log.info(single_line(text, _SHOWN_CHARACTERS))

    def _hint(self, buffer: LineBuffer) -> None:
        """Say what may be wrong if no line has come."""
        if self.tally.received:
            return
        if len(buffer):
            self._log.warning("bytes come, but no line ends: print with println()")
        else:
            self._log.warning(
                f"no line has come for {_SILENCE_S:.0f} s: does the board's program print? "
                "`zbot serial --sketch arduino` shows one that does"
            )

    # -- the way back --------------------------------------------------------------------------

    def _reopened(self) -> Any:
        """Return the port when the board is back, or None if the program ends."""
        said = ""
        while self._node.context.ok():
            time.sleep(_SEARCH_S)
            try:
                if self._is_found:
                    self._info = self._found()
                return ports.open_port(self._info.device, self._options.baud)
            except ports.NoPortError:
                continue
            except DeviceError as error:
                if str(error) != said:  # the system may give the permission a moment later
                    self._log.debug(str(error))
                said = str(error)
        return None

    def _found(self) -> PortInfo:
        """Return the port of the board that was unplugged."""
        for info in ports.all_ports():
            if info.identity == self._info.identity:
                return info
        raise ports.NoPortError("the board is not there")

    # -- to the board --------------------------------------------------------------------------

    def _send(self, received: Received) -> None:
        text = text_of(received.message, received.field, ("0", "1"))
        line = f"{received.address}: {' '.join(text.splitlines())}\n".encode()
        with self._has_lines:
            if self._port is None:
                lost = "the board is not plugged in"
            elif len(self._to_board) >= _WAITING_LINES:
                self._to_board.popleft()
                lost = f"the board is slower than the topic: {counted(_WAITING_LINES, 'line')} wait"
            else:
                lost = ""
            if self._port is not None:
                self._to_board.append(line)
                self._has_lines.notify()
        if lost:
            self.tally.lose(lost, received.address)

    def _write(self, is_over: threading.Event) -> None:
        """Write lines to the board, in a thread."""
        separator = b""
        while not is_over.is_set():
            with self._has_lines:
                self._has_lines.wait_for(lambda: self._to_board and self._port, 0.5)
                if not self._to_board or self._port is None:
                    continue
                line, opened = self._to_board.popleft(), self._port
            try:
                opened.write(separator + line)
            except (OSError, TypeError) as error:  # TypeError: the port was closed meanwhile
                separator = b"\n"  # a part of the line may be on its way
                self.tally.lose("the board took no line within a second", str(error))
            else:
                separator = b""
                self.tally.sent += 1
