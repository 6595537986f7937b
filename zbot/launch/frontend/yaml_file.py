"""Reader of launch files in YAML."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.errors import InvalidFrontendLaunchFileError
from zbot.launch.frontend.entity import Entity
from zbot.text.yaml_reader import YamlError, compose_yaml, construct_yaml

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["Entity", "load", "parse"]

_ROOT, _CHILDREN = "launch", "children"


def load(path: Path) -> Entity:
    """Return the tree of a file. See `parse`."""
    try:
        return parse(path.read_text(encoding="utf-8"), str(path))
    except UnicodeDecodeError as error:
        raise InvalidFrontendLaunchFileError(str(path), 0, f"YAML: {error}") from error


def parse(content: str, path: str) -> Entity:
    """Return the tree of YAML content.

    Raises:
        InvalidFrontendLaunchFileError: The content is not YAML or is not a launch file.
    """
    try:
        return _Reader(path).root(compose_yaml(content))
    except YamlError as error:
        line = error.line + 1 if error.line is not None else 0
        raise InvalidFrontendLaunchFileError(path, line, f"YAML: {error.problem}") from error


class _Reader:
    """Converts YAML nodes, which have line numbers, into entities."""

    def __init__(self, path: str) -> None:
        import yaml  # noqa: PLC0415 - takes 15 ms; most launch files are Python

        self._path, self._yaml = path, yaml

    def root(self, node: Any) -> Entity:
        pairs = self._pairs(node) if self._is_mapping(node) else []
        if len(pairs) != 1 or pairs[0][0] != _ROOT:
            line = node.start_mark.line + 1 if node is not None else 1
            reason = "a launch file in YAML begins with `launch:` and a list below it"
            raise InvalidFrontendLaunchFileError(self._path, line, reason)
        return self._entity(_ROOT, pairs[0][1])

    def _entity(self, name: str, node: Any) -> Entity:
        attributes: dict[str, Any] = {}
        written: dict[str, Any] = {}
        children: list[Entity] = []
        line = node.start_mark.line + 1
        if self._is_sequence(node):
            children = self._children(node)
        elif self._is_mapping(node):
            for key, value in self._pairs(node):
                if key == _CHILDREN:
                    children += self._children(value)
                elif self._has_mappings(value):
                    children += [self._entity(key, item) for item in value.value]
                elif self._is_mapping(value):
                    children.append(self._entity(key, value))
                else:
                    attributes[key] = construct_yaml(value)
                    written[key] = construct_yaml(value, as_strings=True)
        elif node.value:
            reason = f"below `{name}` write `attribute: value`, not '{node.value}'"
            raise InvalidFrontendLaunchFileError(self._path, line, reason)
        return Entity(name, attributes, children, self._path, line, written=written)

    def _children(self, node: Any) -> list[Entity]:
        if not self._is_sequence(node):
            self._refuse(node)
        found: list[Entity] = []
        for item in node.value:
            if not self._is_mapping(item) or len(item.value) != 1:
                self._refuse(item)
            (name, value), *_ = self._pairs(item)
            entity = self._entity(name, value)
            entity.line = item.start_mark.line + 1
            found.append(entity)
        return found

    def _refuse(self, node: Any) -> None:
        reason = (
            "each item of the list must be one action, e.g. `- node:` with its attributes below"
        )
        raise InvalidFrontendLaunchFileError(self._path, node.start_mark.line + 1, reason)

    def _pairs(self, node: Any) -> list[tuple[str, Any]]:
        return [(str(key.value), value) for key, value in node.value]

    def _is_mapping(self, node: Any) -> bool:
        return isinstance(node, self._yaml.MappingNode)

    def _is_sequence(self, node: Any) -> bool:
        return isinstance(node, self._yaml.SequenceNode)

    def _has_mappings(self, node: Any) -> bool:
        return self._is_sequence(node) and bool(node.value) and self._is_mapping(node.value[0])
