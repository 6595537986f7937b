"""Library MuJoCo, which is imported when a world is made."""

from __future__ import annotations

import importlib
from functools import cache
from typing import Any

from zbot.errors import MissingPackageError
from zbot.log import get_logger

#: Seconds of a step of the physics.
STEP_S = 0.004
#: Memory for contacts. The system gives it only when it is used. More contacts are an error.
MEMORY_BYTES = 256 * 1024 * 1024


@cache
def engine() -> Any:
    """Return the module `mujoco`.

    Raises:
        MissingPackageError: The extra `sim` is not installed.
    """
    try:
        mujoco = importlib.import_module("mujoco")
    except ModuleNotFoundError as error:
        raise MissingPackageError("the simulator", "MuJoCo", "sim") from error
    # Otherwise MuJoCo writes warnings to a file in the current folder.
    mujoco.set_mju_user_warning(_log)
    return mujoco


def _log(text: str) -> None:
    get_logger("simulator").debug(text)


def new_spec() -> Any:
    """Return an empty `MjSpec` with zbot's settings of the physics."""
    mujoco = engine()
    spec = mujoco.MjSpec()
    spec.option.timestep = STEP_S
    spec.memory = MEMORY_BYTES
    # This integrator stays stable with motors that hold a speed.
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    # The time constant of a contact: MuJoCo needs at least two steps.
    spec.default.geom.solref = (2.5 * STEP_S, 1.0)
    return spec
