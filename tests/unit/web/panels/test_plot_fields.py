"""Tests of the fields that the panel Plot offers for the topics of a domain."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from tests.unit.tokens import endpoint_token
from zbot.graph.snapshot import Snapshot
from zbot.interfaces import registry
from zbot.package.user_folders import definitions_folder
from zbot.web.panels import plot as plot_panel
from zbot.web.panels.plot import _Plot

if TYPE_CHECKING:
    from collections.abc import Mapping


def plot(types: Mapping[str, str]) -> _Plot:
    """Return a plot without elements, in a domain with topics of some types."""
    tokens = [endpoint_token(topic, type_name=name) for topic, name in types.items()]
    graph = Snapshot(tuple(tokens))
    made = object.__new__(_Plot)
    made.page = SimpleNamespace(  # type: ignore[assignment]
        system=SimpleNamespace(snapshot=lambda: graph)
    )
    made.known = {}
    return made


def test_a_topic_whose_definition_is_wrong_is_left_out() -> None:
    folder = definitions_folder() / "wrong_msgs" / "msg"
    folder.mkdir(parents=True)
    (folder / "Typo.msg").write_text("int32\n")
    (folder / "Half.msg").write_text("other_msgs/Part part\n")
    types = {
        "/typo": "wrong_msgs/msg/Typo",
        "/half": "wrong_msgs/msg/Half",
        "/x": "std_msgs/msg/Float64",
    }
    assert plot(types).fields() == {"/x": ["data"]}


def test_fields_of_a_type_are_found_once_and_nothing_is_suggested_for_an_unknown_type(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made: list[object] = []

    def fields(message: object) -> list[str]:
        made.append(message)
        return ["data"]

    monkeypatch.setattr(registry, "packages", lambda: pytest.fail("all folders are scanned"))
    monkeypatch.setattr(plot_panel, "numeric_fields", fields)
    page = plot(
        {"/a": "nobody_msgs/msg/A", "/b": "std_msgs/msg/Int8", "/c": "std_msgs/msg/Int8", "/d": "E"}
    )
    for _ in range(2):
        assert page.fields() == {"/b": ["data"], "/c": ["data"]}
    assert len(made) == 1
