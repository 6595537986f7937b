"""ROS 2's dialect beside zbot's own and raw Zenoh: messages a second, round trips and CPU time."""

from __future__ import annotations

import socket
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING

from benchmarks.busy_waiting import steady
from benchmarks.contestant import RAW_WAYS, RCLPY, ZBOT, Contestant
from benchmarks.interleaving import Row, measured
from benchmarks.round_trips import round_trip
from benchmarks.throughput import one_way, type_facts
from zbot.transport.rmw_choice import RMW_VARIABLE, RMW_ZENOH
from zbot.transport.rmw_meeting import RmwRouter

if TYPE_CHECKING:
    from collections.abc import Iterator

    from benchmarks.report import Report

RATE = 1000.0
TRIP_BYTES = 64
_TRIPS = 4000


@contextmanager
def speaking_ros2() -> Iterator[Contestant]:
    """Open a router of ROS 2. Yield programs of zbot that use it and speak ROS 2's dialect."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        endpoint = f"tcp/127.0.0.1:{probe.getsockname()[1]}"
    override = f'connect/endpoints=["{endpoint}"]'
    variables = {RMW_VARIABLE: RMW_ZENOH, "ZENOH_CONFIG_OVERRIDE": override}
    with RmwRouter([endpoint], []).open():
        yield Contestant("zbot, ROS 2's dialect", variables=variables)


def rows() -> list[Row]:
    facts = type_facts()["Imu"]
    imu = partial(one_way, kind="Imu", size=facts["bytes"], queue=facts["queue"])
    return [
        Row("Imu, as fast as possible", imu),
        Row(f"round trip of {TRIP_BYTES} B", partial(round_trip, size=TRIP_BYTES, count=_TRIPS)),
        Row("Imu at 1 kHz", partial(steady, rate=RATE, kind="Imu", size=facts["bytes"])),
    ]


def table(report: Report, rounds: int) -> None:
    report.head(
        "ROS 2's dialect: Imu, and round trips of 64 B",
        *("contestant", "msg/s", "lost", "CPU us a message", "round trip p50 us", "p99 us"),
        "CPU % at 1 kHz, both processes",
    )
    with speaking_ros2() as ros2:
        contestants = [*RAW_WAYS, ZBOT, ros2, *RCLPY]
        flood, trips, at_rate = (measured(row, contestants, rounds) for row in rows())
    for name in flood.names():
        lost = f"{flood.median(name, 'lost'):.0f}"
        times = [trips.median(name, metric) for metric in ("p50", "p99")]
        report.row(
            name,
            f"{flood.median(name, 'rate'):,.0f}",
            "most"
            if name in [contestant.name for contestant in RCLPY]
            else lost,  # see rclpy_program.py
            f"{flood.median(name, 'cpu'):.1f}",
            *(f"{time:.0f}" for time in times),
            f"{at_rate.median(name, 'sum'):.1f}",
        )
