"""Model of three coordinate axes in a GLB file, which browsers draw many times.

viser's own axes are round: 192 triangles a frame, which cost much where WebGL runs in software.
These have square sections: 30 triangles a frame.
"""

from __future__ import annotations

import json
import struct

import numpy as np

# The colours of viser's axes, as the amounts of light that a GLB file contains.
_LIGHT = 0.604
_QUADS = ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7))
_FLOAT, _WORD = 5126, 5123
_MAGIC, _JSON, _BINARY = 0x46546C67, 0x4E4F534A, 0x004E4942


def axes_glb(length: float, radius: float) -> bytes:
    """Return a GLB file with the axes x (red), y (green) and z (blue), without shading.

    Args:
        length: The length of each axis in metres.
        radius: Half of its thickness in metres.
    """
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    z_axis = np.array(
        [(x * radius, y * radius, z) for z in (0.0, length) for x, y in corners], np.float32
    )
    # The same turn of the coordinates keeps the triangles' outer sides outside.
    positions = np.concatenate([np.roll(z_axis, turns, axis=1) for turns in (1, 2, 0)])
    colors = np.repeat(np.eye(3, dtype=np.float32) * _LIGHT, len(z_axis), axis=0)
    faces = [(a, b, c) for a, b, c, _ in _QUADS] + [(a, c, d) for a, _, c, d in _QUADS]
    indices = np.concatenate([np.array(faces, np.uint16) + 8 * axis for axis in range(3)])
    return _file(positions, colors, indices)


def _file(positions: np.ndarray, colors: np.ndarray, indices: np.ndarray) -> bytes:
    parts = [positions.tobytes(), colors.tobytes(), indices.tobytes()]
    starts = [0, len(parts[0]), len(parts[0]) + len(parts[1])]
    data = b"".join(parts)
    views = [
        {"buffer": 0, "byteOffset": start, "byteLength": len(part)}
        for start, part in zip(starts, parts, strict=True)
    ]
    limits = {"min": positions.min(axis=0).tolist(), "max": positions.max(axis=0).tolist()}
    vectors = {"componentType": _FLOAT, "count": len(positions), "type": "VEC3"}
    numbers = {"componentType": _WORD, "count": indices.size, "type": "SCALAR"}
    primitive = {"attributes": {"POSITION": 0, "COLOR_0": 1}, "indices": 2, "material": 0}
    scene = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_materials_unlit"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}],
        "materials": [{"extensions": {"KHR_materials_unlit": {}}}],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": views,
        "accessors": [
            {"bufferView": 0, **vectors, **limits},
            {"bufferView": 1, **vectors},
            {"bufferView": 2, **numbers},
        ],
    }
    chunks = _chunk(_JSON, json.dumps(scene).encode(), b" ") + _chunk(_BINARY, data, b"\0")
    return struct.pack("<III", _MAGIC, 2, 12 + len(chunks)) + chunks


def _chunk(kind: int, data: bytes, filler: bytes) -> bytes:
    data += filler * (-len(data) % 4)
    return struct.pack("<II", len(data), kind) + data
