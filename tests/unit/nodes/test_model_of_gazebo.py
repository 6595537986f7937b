"""Tests of the models that Gazebo Classic's spawner finds by their names."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot_nodes.simulation.descriptions import from_models

if TYPE_CHECKING:
    from pathlib import Path


def test_a_model_is_found_by_its_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "cafe_table").mkdir()
    (tmp_path / "cafe_table" / "model.sdf").write_text("<sdf/>")
    monkeypatch.setenv("GAZEBO_MODEL_PATH", str(tmp_path))
    assert from_models("cafe_table") == "<sdf/>"
    with pytest.raises(SystemExit, match="there is no model 'chair' on this machine: put its"):
        from_models("chair")
