"""Conversion between point clouds and numpy arrays, as in `sensor_msgs_py.point_cloud2`.

This module needs numpy, which `pip install "zbot[numpy]"` installs.
"""

from __future__ import annotations

import sys
from collections import namedtuple
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError, require_numpy

from sensor_msgs.msg import PointCloud2, PointField

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from std_msgs.msg import Header

#: numpy's code for each of PointField's data types.
_CODES = {
    PointField.INT8: "i1",
    PointField.UINT8: "u1",
    PointField.INT16: "i2",
    PointField.UINT16: "u2",
    PointField.INT32: "i4",
    PointField.UINT32: "u4",
    PointField.FLOAT32: "f4",
    PointField.FLOAT64: "f8",
}
_UNNAMED = "unnamed_field"
_MOST_VALUES = 10_000  #: of one point: the count in a message of another program can be huge


class PointCloudError(ZbotError, AssertionError):
    """The fields, the points or the data of a cloud are not valid."""


def dtype_from_fields(
    fields: Iterable[PointField], point_step: int | None = None
) -> np.dtype[np.void]:
    """Return numpy's structured type of one point.

    Args:
        fields: The fields of a point. A field `x` with a count of 3 becomes `x_0`, `x_1`, `x_2`.
        point_step: Bytes from one point to the next. The default is the size of the fields.

    Raises:
        PointCloudError: Two fields have the same name, a field has an unknown data type, or a
            point has more than 10,000 values.
    """
    return _dtype(fields, point_step, "=")


def _dtype(fields: Iterable[PointField], point_step: int | None, order: str) -> np.dtype[np.void]:
    require_numpy("point_cloud2")
    import numpy as np  # noqa: PLC0415 - part of an extra

    names: list[str] = []
    offsets: list[int] = []
    formats: list[str] = []
    for index, field in enumerate(fields):
        if field.datatype not in _CODES:
            raise PointCloudError(f"field '{field.name}' has the unknown type {field.datatype}")
        size = int(_CODES[field.datatype][1])
        name = field.name or f"{_UNNAMED}_{index}"
        if len(names) + field.count > _MOST_VALUES:
            raise PointCloudError(f"a point has more than {_MOST_VALUES} values")
        for item in range(field.count):
            names.append(f"{name}_{item}" if field.count > 1 else name)
            offsets.append(field.offset + item * size)
            formats.append(order + _CODES[field.datatype])
    if len(set(names)) < len(names):
        raise PointCloudError(f"two fields have the same name: {', '.join(names)}")
    parts: dict[str, Any] = {"names": names, "formats": formats, "offsets": offsets}
    if point_step is not None:
        parts["itemsize"] = point_step
    return np.dtype(parts)  # type: ignore[call-overload,no-any-return]


def read_points(
    cloud: PointCloud2,
    field_names: Iterable[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> NDArray[np.void]:
    """Return the points of a cloud as a structured array. `points['x']` has the x of all points.

    Args:
        cloud: The cloud. Its bytes are copied only if necessary.
        field_names: The fields to return. The default is all fields.
        skip_nans: Leave out points with a value that is NaN. This is not checked if the cloud's
            `is_dense` is true.
        uvs: The indices of the points to return.
        reshape_organized_cloud: Return an array of two dimensions for a cloud with several rows.

    Raises:
        PointCloudError: The cloud has no such field, or less data than its size needs.
    """
    points = _all_points(cloud)
    if field_names is not None:
        points = _with_fields(points, list(field_names))
    if skip_nans and not cloud.is_dense:
        points = points[~_has_nan(points)]
    if uvs is not None:
        points = points[_indices(uvs)]
    if reshape_organized_cloud and cloud.height > 1:
        points = points.reshape(cloud.height, cloud.width)
    return points


def _all_points(cloud: PointCloud2) -> NDArray[np.void]:
    require_numpy("point_cloud2")
    import numpy as np  # noqa: PLC0415 - part of an extra

    dtype = _dtype(cloud.fields, cloud.point_step, ">" if cloud.is_bigendian else "<")
    row_step = cloud.row_step if cloud.height > 1 else 0
    row_step = max(row_step, cloud.width * cloud.point_step)
    last_row = cloud.width * cloud.point_step
    needed = (cloud.height - 1) * row_step + last_row if cloud.height and cloud.width else 0
    if len(cloud.data) < needed:
        raise PointCloudError(
            f"a cloud of {cloud.width}x{cloud.height} points needs {needed} bytes, "
            f"but it has {len(cloud.data)}"
        )
    shape = (cloud.height, cloud.width)
    rows: Any = np.ndarray(shape, dtype, memoryview(cloud.data), 0, (row_step, cloud.point_step))
    points = rows.reshape(-1)
    return points.astype(dtype.newbyteorder("=")) if not dtype.isnative else points  # type: ignore[no-any-return]


def _with_fields(points: NDArray[np.void], names: list[str]) -> NDArray[np.void]:
    known = points.dtype.names or ()
    missing = [name for name in names if name not in known]
    if missing:
        raise PointCloudError(f"the cloud has no field {missing[0]!r}; it has {', '.join(known)}")
    return points[names]


def _has_nan(points: NDArray[np.void]) -> NDArray[np.bool_]:
    require_numpy("point_cloud2")
    import numpy as np  # noqa: PLC0415 - part of an extra

    columns = [np.isnan(points[name]) for name in points.dtype.names or ()]
    found: NDArray[np.bool_] = np.any(columns, axis=0)
    return found


def _indices(uvs: Iterable[int]) -> NDArray[np.int_]:
    require_numpy("point_cloud2")
    import numpy as np  # noqa: PLC0415 - part of an extra

    return uvs if isinstance(uvs, np.ndarray) else np.fromiter(uvs, int)


def read_points_numpy(
    cloud: PointCloud2,
    field_names: Iterable[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> NDArray[Any]:
    """Return the points of a cloud as an array of shape (points, fields). See `read_points`.

    Raises:
        PointCloudError: The fields have different data types, so no such array can hold them.
    """
    from numpy.lib.recfunctions import structured_to_unstructured  # noqa: PLC0415 - part of an extra

    names = None if field_names is None else list(field_names)
    wanted = [field for field in cloud.fields if names is None or field.name in names]
    _check_one_type(wanted)
    points = read_points(cloud, names, skip_nans, uvs, reshape_organized_cloud)
    found: NDArray[Any] = structured_to_unstructured(points)
    return found


def _check_one_type(fields: Sequence[PointField]) -> None:
    if len({field.datatype for field in fields}) > 1:
        raise PointCloudError("the fields have different data types: use read_points()")


def read_points_list(
    cloud: PointCloud2,
    field_names: Iterable[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
) -> list[Any]:
    """Return the points of a cloud as named tuples, e.g. `points[0].x`. See `read_points`."""
    points = read_points(cloud, field_names, skip_nans, uvs)
    point = namedtuple("Point", points.dtype.names or ())  # type: ignore[misc]
    return [point._make(each) for each in points]


def create_cloud(
    header: Header,
    fields: Iterable[PointField],
    points: Any,
    step: int | None = None,
    point_step: int | None = None,
) -> PointCloud2:
    """Return points as a cloud.

    Args:
        header: Frame of the points, and the time of their measurement.
        fields: The fields of a point.
        points: An array of shape (points, fields) or (width, height, fields), a structured array,
            or a list with the values of each point.
        step: Bytes from one point to the next. The default is the size of the fields, or the size
            of a structured array's element.
        point_step: Another name for `step`.

    Raises:
        PointCloudError: The points do not fit the fields.
    """
    fields = list(fields)
    array = _structured(fields, points, step if step is not None else point_step)
    width, height = (array.shape[0], array.shape[1] if array.ndim > 1 else 1)
    return PointCloud2(
        header=header,
        height=height,
        width=width,
        is_dense=False,
        is_bigendian=sys.byteorder != "little",
        fields=fields,
        point_step=array.dtype.itemsize,
        row_step=array.dtype.itemsize * width,
        data=array.tobytes(),
    )


def _structured(fields: Sequence[PointField], points: Any, step: int | None) -> NDArray[np.void]:
    require_numpy("point_cloud2")
    import numpy as np  # noqa: PLC0415 - part of an extra
    from numpy.lib.recfunctions import unstructured_to_structured  # noqa: PLC0415 - part of an extra

    if not isinstance(points, np.ndarray):
        return np.array(list(map(tuple, points)), dtype=dtype_from_fields(fields, step))
    if points.dtype.names is None:
        _check_one_type(fields)
        found: NDArray[np.void] = unstructured_to_structured(
            points, dtype_from_fields(fields, step)
        )
        return found
    expected = dtype_from_fields(fields, points.dtype.itemsize if step is None else step)
    if points.dtype != expected:
        raise PointCloudError(f"the points are {points.dtype}, but the fields say {expected}")
    return points


def create_cloud_xyz32(
    header: Header, points: Any, step: int | None = None, point_step: int | None = None
) -> PointCloud2:
    """Return points of three coordinates each, in metres, as a cloud. See `create_cloud`."""
    fields = [
        PointField(name=name, offset=4 * index, datatype=PointField.FLOAT32, count=1)
        for index, name in enumerate("xyz")
    ]
    return create_cloud(header, fields, points, step, point_step)
