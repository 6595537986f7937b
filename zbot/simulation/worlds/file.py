"""Worlds by name, and worlds from files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.errors.suggestion import did_you_mean
from zbot.simulation.errors import SimulationError
from zbot.simulation.sdf.world import sdf_world
from zbot.simulation.worlds.catalog import WORLDS
from zbot.simulation.worlds.map import map_spec
from zbot.simulation.worlds.mjcf import mjcf_spec
from zbot.simulation.worlds.plan import Place

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.simulation.sdf.world import Entity

_SDF = frozenset({".sdf", ".world"})
_READERS: dict[str, Callable[[Path], Any]] = {
    ".yaml": map_spec,
    ".yml": map_spec,
    ".xml": mjcf_spec,
}


class FoundWorld(NamedTuple):
    """World without robots."""

    spec: Any  #: an `MjSpec`
    start: Place  #: where the first robot starts
    name: str = "default"  #: its name in the topics of Gazebo
    entities: Sequence[Entity] = ()  #: its models with sensors or plugins
    notices: Sequence[str] = ()  #: what is left out
    earth: tuple[float, float, float] | None = None  #: where its origin is on the Earth


def find_world(name: str) -> FoundWorld:
    """Return the world of a name, of a map in YAML, or of a file in SDF or MJCF.

    Raises:
        SimulationError: There is no such world or file, or it cannot be simulated.
    """
    if name in WORLDS:
        plan = WORLDS[name]()
        return FoundWorld(plan.spec(), plan.start)
    path = Path(name)
    if path.suffix in _SDF:
        _check(path)
        found = sdf_world(path)
        rest = (found.name, found.entities, found.notices, found.earth)
        return FoundWorld(found.spec, Place(), *rest)
    read = _READERS.get(path.suffix)
    if read is None:
        hint = did_you_mean(name, WORLDS, before="; ")
        raise SimulationError(
            f"there is no world '{name}'{hint} (worlds: {', '.join(WORLDS)}, "
            "a map .yaml, a file .sdf or .world, or a file .xml in MJCF)"
        )
    _check(path)
    return FoundWorld(read(path), Place())


def _check(path: Path) -> None:
    if not path.is_file():
        raise SimulationError(f"there is no file {path}")
