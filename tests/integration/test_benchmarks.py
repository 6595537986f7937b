from __future__ import annotations

import pytest

from benchmarks import busy_waiting, cdr, dialect, round_trips, throughput
from benchmarks.contestant import ASLEEP, POLLING, RAW_WAYS, ZBOT, Contestant, environment
from benchmarks.report import Report
from benchmarks.throughput import one_way

pytestmark = pytest.mark.own_dialect("it measures zbot's own form, without a router of ROS 2")

CONTESTANTS = pytest.mark.parametrize(
    "contestant", [ZBOT, ASLEEP, *RAW_WAYS], ids=lambda contestant: contestant.name
)


@pytest.fixture(autouse=True)
def in_own_domain(free_domain: int, monkeypatch: pytest.MonkeyPatch) -> None:
    def in_domain(contestant: Contestant) -> dict[str, str]:
        return environment(contestant) | {"ZBOT_DOMAIN_ID": str(free_domain)}

    for module in (busy_waiting, round_trips, throughput):
        monkeypatch.setattr(module, "environment", in_domain)
    monkeypatch.setattr(throughput, "SECONDS", 0.05)


@CONTESTANTS
def test_a_flood_arrives_without_losses(contestant: Contestant) -> None:
    found = one_way(contestant, "JointState, 6 joints", size=289, queue=256)
    assert found["lost"] == 0
    assert found["rate"] > 0
    assert found["cpu"] > 0


@pytest.mark.parametrize(
    "contestant", [ZBOT, ASLEEP, POLLING], ids=lambda contestant: contestant.name
)
def test_round_trips_are_timed(contestant: Contestant) -> None:
    found = round_trips.round_trip(contestant, size=64, count=100)
    assert 0 < found["p50"] <= found["p99"] <= found["p99.9"]


@pytest.mark.parametrize("contestant", [ZBOT, RAW_WAYS[0]], ids=lambda contestant: contestant.name)
def test_a_large_flood_arrives_without_losses(contestant: Contestant) -> None:
    assert one_way(contestant, 1_000_000, size=1_000_040, queue=256)["lost"] == 0


def test_twelve_types_are_sent() -> None:
    facts = throughput.type_facts()
    assert len(facts) == 12
    assert all(fact["bytes"] > 0 for fact in facts.values())


def test_the_dialect_of_ros_2_is_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(dialect, "_TRIPS", 100)
    monkeypatch.setattr(busy_waiting, "SECONDS", 0.2)
    with dialect.speaking_ros2() as ros2:
        flood, trips, at_rate = (row.run(ros2) for row in dialect.rows())
    assert (flood["lost"], flood["rate"] > 0) == (0, True)
    assert 0 < trips["p50"] <= trips["p99"]
    assert at_rate["sum"] > 0


def test_cdr_is_measured_beside_messagepack(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(cdr, "_ROUND_S", 0.0)
    monkeypatch.setattr(cdr, "_ROUNDS", 1)
    cdr.table(Report())
    rows = [line for line in capsys.readouterr().out.splitlines() if line.startswith("| ")]
    assert len(rows) == 1 + len(cdr.MESSAGES)
