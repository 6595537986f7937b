"""Worlds in MuJoCo's own format MJCF."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.libraries.robot_description.file import read_description
from zbot.libraries.robot_description.xml_text import DescriptionError, read_xml
from zbot.simulation.engine import MEMORY_BYTES, STEP_S, engine
from zbot.simulation.errors import SimulationError
from zbot.simulation.worlds.mjcf_limits import check_mjcf

if TYPE_CHECKING:
    from pathlib import Path

#: More rounds of the solver would let a step take seconds.
_MOST_ROUNDS = 100


def mjcf_spec(path: Path) -> Any:
    """Return the world in a file.

    Raises:
        SimulationError: The file is too large, has a tag that is not allowed, or is not MJCF.
    """
    try:
        root = read_xml(read_description(path))
    except DescriptionError as error:
        raise SimulationError(f"{path} is not a world in MJCF: {error.reason}") from error
    if root.tag != "mujoco":
        raise SimulationError(f"{path} is not a world in MJCF: its outermost tag is <{root.tag}>")
    try:
        check_mjcf(root, path.parent)
    except SimulationError as error:
        raise SimulationError(f"{path} cannot be simulated: {error}") from error
    try:
        spec = engine().MjSpec.from_file(str(path))
    except (ValueError, RuntimeError, engine().FatalError) as error:
        reason = " ".join(str(error).split()).removeprefix("Error: ")
        raise SimulationError(f"{path} is not a world in MJCF: {reason}") from error
    _set_options(spec)
    return spec


def _set_options(spec: Any) -> None:
    option = spec.option
    option.timestep = STEP_S
    option.integrator = engine().mjtIntegrator.mjINT_IMPLICITFAST
    spec.memory = MEMORY_BYTES
    for name in ("iterations", "ls_iterations", "noslip_iterations", "ccd_iterations"):
        setattr(option, name, min(getattr(option, name), _MOST_ROUNDS))
