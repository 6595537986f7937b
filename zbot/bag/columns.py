"""Columns of numbers from the messages of a topic, as numpy arrays or as a pandas table."""

from __future__ import annotations

import csv
import io
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagError, BagValueError, bag_topic_error
from zbot.bag.reader import Reader
from zbot.errors import require_numpy
from zbot.errors.installation import pip_install
from zbot.interfaces import get_spec
from zbot.wire.serialization import deserialize_message

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from pathlib import Path

    from zbot.interfaces.spec import FieldType

TIME_COLUMN = "t"
_SEPARATOR = "."
_MOST_COLUMNS = 1000  # of one field in a CSV table, because spreadsheets cannot show more


class NoPandasError(BagError, ImportError):
    """The package pandas is not installed."""

    def __init__(self) -> None:
        super().__init__(f"to_pandas needs pandas: install it with {pip_install('pandas')}")


def to_numpy(path: str | Path, topic: str, fields: Sequence[str] | None = None) -> dict[str, Any]:
    """Return the values of a topic as numpy arrays.

        columns = zbot.bag.to_numpy("lesson", "/turtle1/pose", ["x", "y"])
        print(columns["x"].mean())

    Args:
        path: Folder of a bag, or one of its files.
        topic: The topic.
        fields: Names of fields, with dots inside messages, e.g. `pose.position.x`. `None` means
            all.

    Returns:
        An array for each field, with a value for each message. Key `t` is the time of recording in
        seconds since the first message of the topic (float64). Arrays that have the same length in
        all messages become a second dimension. Other arrays and texts have the dtype object.

    Raises:
        BagNotFoundError: There is nothing with this path.
        BagReadError: The path is not a bag, or a part of the bag is damaged.
        BagValueError: The bag does not have the topic, or the messages do not have a field.
        BagTypeError: The type is not known, or is different here, or messages are not in CDR.
        CodecError: The bytes of a message do not fit its type.
        NoBagExtraError: The extra `bag` is not installed.
    """
    require_numpy("to_numpy()")
    import numpy as np  # noqa: PLC0415 - takes 100 ms

    times, columns = topic_columns(path, topic, fields)
    stamps = np.array(times, dtype=np.int64)
    seconds = (stamps - stamps[0]) / 1e9 if times else np.zeros(0)
    return {TIME_COLUMN: seconds} | {name: _array(values) for name, values in columns.items()}


def to_pandas(path: str | Path, topic: str, fields: Sequence[str] | None = None) -> Any:
    """Return the values of a topic as a pandas `DataFrame`.

        zbot.bag.to_pandas("lesson", "/turtle1/pose")["x"].plot()

    Args:
        path: Folder of a bag, or one of its files.
        topic: The topic.
        fields: As for `to_numpy`.

    Returns:
        A table with a row for each message and a column for each field. Its index is the time of
        recording, in UTC. Arrays and texts have the dtype object.

    Raises:
        NoPandasError: pandas is not installed. The errors of `to_numpy` are raised too.
    """
    try:
        import pandas as pd  # noqa: PLC0415  # pyright: ignore[reportMissingImports] - 400 ms
    except ImportError:
        raise NoPandasError from None
    times, columns = topic_columns(path, topic, fields)
    index = pd.to_datetime(times, unit="ns", utc=True).rename("time")
    return pd.DataFrame(columns, index=index)


def csv_lines(
    path: str | Path, topic: str, start_ns: int = 0, end_ns: int | None = None
) -> Iterator[str]:
    """Yield the lines of a CSV table: a title, and a line for each message.

    The column `time` is the time of recording in seconds since the epoch. Each number of an array
    has its own column, e.g. `ranges[0]`, if the array has the same length in all messages and at
    most 1,000 numbers. Other arrays have one column. The bag is read twice, and only one message is
    in the memory at a time.

    Args:
        path: Folder of a bag, or one of its files.
        topic: The topic.
        start_ns: First time, in nanoseconds since the epoch.
        end_ns: Last time. `None` means no limit.

    Raises:
        BagError: The errors of `to_numpy`.
    """
    with Reader(path) as bag:
        table = _Table(bag, topic, None)
        lengths: list[set[int]] = [set() for _ in table.fields]
        for _, values in table.rows(start_ns, end_ns):
            for seen, value in zip(lengths, values, strict=True):
                seen.add(len(value) if _is_list(value) else -1)
        # The number of cells for each field, or -1 if the field has one cell.
        widths = [seen.pop() if len(seen) == 1 else -1 for seen in lengths]
        widths = [-1 if width > _MOST_COLUMNS else width for width in widths]
        names = ["time"]
        for field, width in zip(table.fields, widths, strict=True):
            names += [field] if width < 0 else [f"{field}[{number}]" for number in range(width)]
        yield _csv_line(names)
        for time_ns, values in table.rows(start_ns, end_ns):
            cells: list[Any] = [f"{time_ns / 1e9:.9f}"]
            for value, width in zip(values, widths, strict=True):
                parts = list(value) if _is_list(value) else value
                cells += [parts] if width < 0 else parts
            yield _csv_line(cells)


def _csv_line(cells: Sequence[Any]) -> str:
    buffer = io.StringIO()
    csv.writer(buffer, lineterminator="\n").writerow(cells)
    return buffer.getvalue()


def fields_of(type_name: str, *, only_numbers: bool = False) -> list[str]:
    """Return the paths of all fields of a message type, with dots inside messages.

    Arrays of messages are left out, because their length is not known.

    Args:
        type_name: `geometry_msgs/msg/Twist`.
        only_numbers: Whether to leave out texts and arrays.
    """
    return [
        path
        for path, kind in _paths(type_name, "")
        if not only_numbers or (kind.kind == "scalar" and not kind.is_string)
    ]


def _paths(type_name: str, prefix: str) -> Iterator[tuple[str, FieldType]]:
    spec: Any = get_spec(type_name)
    for field in spec.fields:
        name = f"{prefix}{field.name}"
        if not field.type.is_message:
            yield name, field.type
        elif field.type.kind == "scalar":
            yield from _paths(field.type.base, f"{name}{_SEPARATOR}")


def topic_columns(
    path: str | Path,
    topic: str,
    fields: Sequence[str] | None,
    start_ns: int = 0,
    end_ns: int | None = None,
) -> tuple[list[int], dict[str, list[Any]]]:
    """Return the times and the values of a topic, without numpy.

    Args:
        path: Folder of a bag, or one of its files.
        topic: The topic.
        fields: As for `to_numpy`.
        start_ns: First time, in nanoseconds since the epoch.
        end_ns: Last time. `None` means no limit.

    Returns:
        The times of recording in nanoseconds since the epoch, and a list of values for each field.

    Raises:
        BagError: The errors of `to_numpy`.
    """
    with Reader(path) as bag:
        table = _Table(bag, topic, fields)
        times: list[int] = []
        values: list[list[Any]] = [[] for _ in table.fields]
        for time_ns, row in table.rows(start_ns, end_ns):
            times.append(time_ns)
            for column, value in zip(values, row, strict=True):
                column.append(value)
    return times, dict(zip(table.fields, values, strict=True))


class _Table:
    """The messages of a topic as rows of values.

    Args:
        bag: The bag. It must stay open.
        topic: The topic.
        fields: As for `to_numpy`.

    Raises:
        BagError: The errors of `to_numpy`.
    """

    def __init__(self, bag: Reader, topic: str, fields: Sequence[str] | None) -> None:
        name = topic if topic in bag.topics else f"/{topic}"
        if name not in bag.topics:
            raise bag_topic_error(topic, f"it is not there; there are {', '.join(bag.topics)}")
        self._class = bag.message_class(bag.topics[name])  # registers a new type
        known = fields_of(bag.topics[name].type_name)
        self.fields = known if fields is None else list(fields)
        missing = next((field for field in self.fields if field not in known), None)
        if missing is not None:
            raise BagValueError(
                f"topic '{topic}' has no field '{missing}'; it has {', '.join(known)}"
            )
        self._bag, self._name = bag, name

    def rows(self, start_ns: int, end_ns: int | None) -> Iterator[tuple[int, list[Any]]]:
        """Yield the time of recording and the values of each message."""
        getters = [attrgetter(field) for field in self.fields]
        for message in self._bag.messages([self._name], start_ns, end_ns):
            decoded = deserialize_message(message.data, self._class)
            yield message.log_ns, [get(decoded) for get in getters]


def _array(values: list[Any]) -> Any:
    import numpy as np  # noqa: PLC0415 - takes 100 ms

    first: Any = values[0] if values else 0.0
    if isinstance(first, (str, bytes)):
        return np.array(values, dtype=object)
    if hasattr(first, "__len__"):
        if len({len(value) for value in values}) == 1 and not (len(first) and _is_text(first[0])):
            return np.array([np.asarray(value) for value in values])
        column = np.empty(len(values), dtype=object)
        column[:] = values
        return column
    return np.array(values)


def _is_list(value: Any) -> bool:
    return hasattr(value, "__len__") and not _is_text(value)


def _is_text(value: Any) -> bool:
    return isinstance(value, (str, bytes))
