"""Tests of the analyzers of diagnostics."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.errors import WrongValueError
from zbot_nodes.diagnostics.analyzer import (
    ERROR,
    OK,
    STALE,
    WARN,
    AnalyzerGroup,
    OtherAnalyzer,
    read_group,
)

from diagnostic_msgs.msg import DiagnosticStatus


def group(**settings: Any) -> AnalyzerGroup:
    parameters = {name.replace("__", "."): value for name, value in settings.items()}
    return read_group("/Robot", parameters)


def generic(**settings: Any) -> AnalyzerGroup:
    own = {f"motors__{name}": value for name, value in settings.items()}
    return group(motors__type="diagnostic_aggregator/GenericAnalyzer", motors__path="Motors", **own)


def take(analyzers: AnalyzerGroup, now_s: float = 0.0, **levels: bytes) -> list[bool]:
    return [
        analyzers.analyze(DiagnosticStatus(name=name, level=level, message=name.upper()), now_s)
        for name, level in levels.items()
    ]


def levels(analyzers: Any, now_s: float = 0.0) -> dict[str, bytes]:
    return {status.name: status.level for status in analyzers.report(now_s)}


@pytest.mark.parametrize(
    "rule",
    [
        {"startswith": ["left"]},
        {"contains": ["ft_mo"]},
        {"name": ["left_motor"]},
        {"name": "left_motor"},
        {"expected": ["left_motor"]},
        {"regex": ["left.*"]},
    ],
)
def test_rules_choose_names(rule: dict[str, Any]) -> None:
    analyzers = generic(**rule)
    assert take(analyzers, left_motor=OK, camera=OK) == [True, False]
    assert levels(analyzers) == {
        "/Robot/Motors": OK,
        "/Robot/Motors/left_motor": OK,
        "/Robot": OK,
    }


def test_the_worst_level_is_that_of_the_summary() -> None:
    analyzers = generic(startswith=["m"])
    take(analyzers, m1=WARN, m2=OK)
    header, *others, robot = analyzers.report(0.0)
    assert (header.level, header.message, robot.level) == (WARN, "Warning", WARN)
    assert [(pair.key, pair.value) for pair in header.values] == [("m1", "M1"), ("m2", "M2")]
    assert [status.name for status in others] == ["/Robot/Motors/m1", "/Robot/Motors/m2"]
    assert [(pair.key, pair.value) for pair in robot.values] == [("Motors", "Warning")]


def test_old_statuses_are_stale() -> None:
    analyzers = generic(startswith=["m"], timeout=1.0)
    take(analyzers, 0.0, m1=OK)
    assert levels(analyzers, 0.9)["/Robot/Motors"] == OK
    assert levels(analyzers, 1.1)["/Robot/Motors"] == STALE
    take(analyzers, 1.1, m2=OK)
    found = levels(analyzers, 1.1)
    assert (found["/Robot/Motors"], found["/Robot/Motors/m1"]) == (ERROR, STALE)
    discarding = generic(startswith=["m"], timeout=1.0, discard_stale=True)
    take(discarding, 0.0, m1=ERROR)
    assert levels(discarding, 1.1) == {"/Robot/Motors": OK, "/Robot": OK}


def test_numbers_and_names_can_be_expected() -> None:
    counted = generic(startswith=["m"], num_items=2)
    assert counted.report(0.0)[0].message == "No items found, expected 2"
    take(counted, m1=OK)
    assert (counted.report(0.0)[0].message, counted.report(0.0)[0].level) == (
        "Expected 2, found 1",
        ERROR,
    )
    named = generic(expected=["m1", "m2"])
    take(named, m1=OK)
    found = levels(named)
    assert (found["/Robot/Motors"], found["/Robot/Motors/m2"]) == (ERROR, STALE)
    assert levels(generic(startswith=["x"], num_items=0)) == {"/Robot/Motors": OK, "/Robot": OK}


def test_beginnings_of_names_are_left_out() -> None:
    analyzers = generic(find_and_remove_prefix=["/base"])
    analyzers.analyze(DiagnosticStatus(name="/base: left/motor"), 0.0)
    assert "/Robot/Motors/left motor" in levels(analyzers)


def test_groups_are_in_groups_and_others_are_discarded_or_ignored() -> None:
    analyzers = group(
        topology__type="diagnostic_aggregator/AnalyzerGroup",
        topology__path="Topology",
        topology__analyzers__left__type="diagnostic_aggregator/GenericAnalyzer",
        topology__analyzers__left__path="Left",
        topology__analyzers__left__contains=["left"],
        analyzers__noise__type="DiscardAnalyzer",
        analyzers__noise__startswith=["noise"],
        analyzers__nothing__type="IgnoreAnalyzer",
    )
    assert take(analyzers, left=ERROR, noise=ERROR, right=OK) == [True, True, False]
    assert levels(analyzers) == {
        "/Robot/Topology/Left": ERROR,
        "/Robot/Topology/Left/left": ERROR,
        "/Robot/Topology": ERROR,
        "/Robot": ERROR,
    }


def test_others_are_reported_only_if_there_are_some() -> None:
    other = OtherAnalyzer("/Other", discards_stale=True, as_errors=True)
    assert other.report(0.0) == []
    other.analyze(DiagnosticStatus(name="x", level=OK), 0.0)
    assert levels(other) == {"/Other": ERROR, "/Other/x": ERROR}
    assert other.report(6.0) == []


@pytest.mark.parametrize(
    ("settings", "reason"),
    [
        ({"type": "my/Own"}, "has the type 'my/Own': there are GenericAnalyzer"),
        ({"type": "GenericAnalyzer"}, "has no rule for names: set startswith"),
        ({"type": "GenericAnalyzer", "regex": ["("]}, "the regex '(' of 'a' is not valid"),
    ],
)
def test_settings_that_cannot_be_used_are_refused(settings: dict[str, Any], reason: str) -> None:
    with pytest.raises(WrongValueError) as caught:
        read_group("", {f"a.{name}": value for name, value in settings.items()})
    assert reason in str(caught.value)
