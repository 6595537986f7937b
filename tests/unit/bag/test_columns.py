"""Tests of the columns of a topic for numpy and pandas."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.unit.bag.messages import write
from zbot.bag import to_numpy, to_pandas
from zbot.bag.columns import csv_lines, fields_of
from zbot.bag.errors import BagValueError

from geometry_msgs.msg import Twist, Vector3
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String
from test_msgs.msg import Arrays

if TYPE_CHECKING:
    from pathlib import Path

TWISTS = [Twist(linear=Vector3(x=float(n)), angular=Vector3(z=0.5)) for n in range(4)]


def test_numbers_become_arrays(path: Path) -> None:
    write(path, TWISTS)
    found = to_numpy(path, "/twist", ["linear.x", "angular.z"])
    assert list(found) == ["t", "linear.x", "angular.z"]
    assert found["linear.x"].dtype == np.float64
    assert found["linear.x"].tolist() == [0, 1, 2, 3]
    assert found["t"].tolist() == [0, 0.001, 0.002, 0.003]
    assert list(to_numpy(path, "twist"))[1:] == fields_of("geometry_msgs/msg/Twist")


def test_arrays_of_one_length_become_a_second_dimension(path: Path) -> None:
    scans = [LaserScan(ranges=[1.0, 2.0], intensities=[1.0] * n) for n in range(3)]
    write(path, [*scans, String(data="a"), Arrays()])
    found = to_numpy(path, "/laserscan")
    assert found["ranges"].shape == (3, 2)
    assert found["intensities"].dtype == object
    assert [len(values) for values in found["intensities"]] == [0, 1, 2]
    assert found["header.frame_id"].tolist() == ["", "", ""]
    assert to_numpy(path, "/string")["data"].tolist() == ["a"]
    assert to_numpy(path, "/arrays")["bool_values"].shape == (1, 3)


def test_pandas_gets_a_row_for_each_message(path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    write(path, TWISTS)
    table = to_pandas(path, "/twist", ["linear.x"])
    assert isinstance(table, pandas.DataFrame)
    assert table["linear.x"].tolist() == [0, 1, 2, 3]
    assert (table.index[1] - table.index[0]).total_seconds() == 0.001


def test_mistakes_say_what_there_is(path: Path) -> None:
    write(path, TWISTS)
    with pytest.raises(BagValueError, match="there are /twist"):
        to_numpy(path, "/pose")
    with pytest.raises(BagValueError, match=r"no field 'x'; it has linear\.x, linear\.y"):
        to_numpy(path, "/twist", ["x"])


def test_a_csv_table_has_a_cell_for_each_number_of_short_arrays(path: Path) -> None:
    scans = [LaserScan(ranges=[float(n), 2.0], intensities=[1.0] * n) for n in range(2)]
    write(path, scans)
    title, *rows = (line.rstrip("\n") for line in csv_lines(path, "/laserscan"))
    names = title.split(",")
    assert names[-3:] == ["ranges[0]", "ranges[1]", "intensities"]
    assert [row.split(",")[-3:] for row in rows] == [["0.0", "2.0", "[]"], ["1.0", "2.0", "[1.0]"]]


def test_the_numbers_of_long_arrays_share_a_cell_in_csv(path: Path) -> None:
    write(path, [LaserScan(ranges=[0.5] * 1001)])
    title, row = csv_lines(path, "/laserscan")
    assert "ranges[0]" not in title
    assert row.count("0.5") == 1001
