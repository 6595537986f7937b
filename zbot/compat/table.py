"""Table of ROS 2's import names: where zbot has `rclpy.node.Node` and all others.

The files `names/*.yaml` are the table. An entry is a module:

    launch.conditions:
      doc: Conditions that decide whether an action is done.
      zbot.launch.condition: AndCondition, IfCondition
      zbot.launch.errors: ConditionError as InvalidConditionExpressionError
      modules:
        if_condition: IfCondition

Most keys are modules that have the names. Other keys are:

- `doc`: the docstring.
- `modules`: submodules in which ROS 2 has some of the names too. `all` means all of the names.
- `like`: another module that has the same names.
- `later`: modules, as above, that Python imports only at the first use of one of their names.
- `is`: the module of zbot which this one is. A test that replaces a name in it replaces it in zbot.

`python -m zbot.compat.generator` writes the modules in `packages/` from this table.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from zbot.text.yaml_reader import read_yaml

_FOLDER = Path(__file__).parent / "names"
_OTHER_KEYS = {"doc", "is", "later", "like", "modules"}


@dataclass
class Module:
    """A module of ROS 2.

    Attributes:
        places: By module of zbot, the names there for each name here.
        later: The same for names that are imported at their first use.
        same: The module of zbot that this one is, or an empty string.
    """

    doc: str
    places: dict[str, dict[str, str]]
    later: dict[str, dict[str, str]] = field(default_factory=dict)
    same: str = ""

    @property
    def names(self) -> list[str]:
        """The names in this module."""
        return [name for found in (*self.places.values(), *self.later.values()) for name in found]

    def part(self, doc: str, names: list[str]) -> Module:
        """Return a module with some of the names."""
        places = {
            place: {here: there for here, there in found.items() if here in names}
            for place, found in self.places.items()
        }
        return Module(doc, {place: found for place, found in places.items() if found})


@cache
def modules() -> dict[str, Module]:
    """Return all modules of the table by their names."""
    found: dict[str, Module] = {}
    for file in sorted(_FOLDER.glob("*.yaml")):
        for name, entry in read_yaml(file.read_text(encoding="utf-8"), as_strings=True).items():
            found[name] = _module(entry, found)
            for last, names in entry.get("modules", {}).items():
                found[f"{name}.{last}"] = _submodule(found[name], name, names)
    return dict(sorted(found.items()))


def _module(entry: dict[str, Any], earlier: dict[str, Module]) -> Module:
    if "like" in entry:
        return Module(entry["doc"], earlier[entry["like"]].places)
    places = {key: value for key, value in entry.items() if key not in _OTHER_KEYS}
    return Module(
        entry["doc"], _places(places), _places(entry.get("later", {})), entry.get("is", "")
    )


def _places(texts: dict[str, str]) -> dict[str, dict[str, str]]:
    """Return the names of each place: of `A, B as C`, the names A and C."""
    pairs = {
        place: [part.split(" as ") for part in text.split(", ")] for place, text in texts.items()
    }
    return {place: {pair[-1]: pair[0] for pair in found} for place, found in pairs.items()}


def _submodule(parent: Module, package: str, text: str) -> Module:
    names = parent.names if text == "all" else text.split(", ")
    shown = (
        f"all names of `{package}`"
        if text == "all"
        else " and ".join(f"`{name}`" for name in names)
    )
    return parent.part(f"ROS 2's module for {shown}.", names)
