"""The model of axes is a file that other programs can read, with all sides outside."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import pytest

from zbot.view.axes_model import axes_glb

trimesh: Any = pytest.importorskip("trimesh", reason="an extra: pip install 'zbot[view]'")


def test_the_axes_are_three_rods_in_three_colours() -> None:
    scene = trimesh.load(io.BytesIO(axes_glb(2.0, 0.1)), file_type="glb")
    (model,) = scene.geometry.values()
    assert model.bounds.tolist() == pytest.approx(np.array([[-0.1] * 3, [2.0] * 3]))
    assert len(model.faces) == 30
    # The sum of a rod's areas with their directions is that of the missing end at the origin.
    for axis in range(3):
        faces = model.faces // 8 == axis
        areas = (model.face_normals * model.area_faces[:, None])[faces.all(axis=1)].sum(axis=0)
        assert areas == pytest.approx(np.eye(3)[axis] * 0.04, abs=1e-6)
        corners = model.vertices[8 * axis : 8 * axis + 8]
        assert corners[:, axis].max() == pytest.approx(2.0)
