"""Tests of the fields that the panel Plot offers for the topics of a domain."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from tests.unit.tokens import endpoint_token
from zbot.graph.snapshot import Snapshot
from zbot.package.user_folders import definitions_folder
from zbot.web.panels.plot import _Plot

if TYPE_CHECKING:
    from collections.abc import Mapping


def plot(types: Mapping[str, str]) -> Any:
    """Return a plot without elements, in a domain with topics of some types."""
    tokens = [endpoint_token(topic, type_name=name) for topic, name in types.items()]
    graph = Snapshot(tuple(tokens))
    system = SimpleNamespace(snapshot=lambda: graph)
    return SimpleNamespace(page=SimpleNamespace(system=system))


def test_a_topic_whose_definition_is_wrong_is_left_out() -> None:
    folder = definitions_folder() / "wrong_msgs" / "msg"
    folder.mkdir(parents=True)
    (folder / "Typo.msg").write_text("int32\n")
    (folder / "Half.msg").write_text("other_msgs/Part part\n")
    page = plot(
        {
            "/typo": "wrong_msgs/msg/Typo",
            "/half": "wrong_msgs/msg/Half",
            "/x": "std_msgs/msg/Float64",
        }
    )
    assert _Plot.fields(page) == {"/x": ["data"]}
