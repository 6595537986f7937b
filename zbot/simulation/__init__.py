"""Simulator: worlds, robots and sensors on the physics of the library MuJoCo.

`worlds/` makes worlds, `robots/` makes bodies and drives from robot descriptions, and `sensors/`
measures. `world.py` puts them together and moves them. None of these needs a node. `node/` is the
node of `zbot sim`.
"""
