"""Parser that builds launch descriptions from the trees of XML and YAML files."""

from __future__ import annotations

from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.launch.action import Action
from zbot.launch.condition import IfCondition, UnlessCondition
from zbot.launch.description import LaunchDescription
from zbot.launch.entity import Origin
from zbot.launch.errors import LaunchFileError
from zbot.launch.frontend import xml_file, yaml_file
from zbot.launch.frontend.registry import ACTIONS
from zbot.launch.frontend.substitution_text import parse, parse_if_substitutions

if TYPE_CHECKING:
    from typing import TextIO

    from zbot.launch.condition import Condition
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.substitution import Substitution

_ROOT = "launch"


class Parser:
    """Builds actions from entities."""

    extensions_loaded = False  #: whether tags of other packages were loaded

    @classmethod
    def load(cls, file: str | PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """Return the tree of a launch file in XML or YAML, and a parser for it.

        Args:
            file: The path of the file, or an open file.

        Raises:
            InvalidFrontendLaunchFileError: The file is not valid XML or YAML.
            OSError: The file cannot be read.
        """
        if isinstance(file, (str, PathLike)):
            content, path = Path(file).read_text(encoding="utf-8"), str(file)
        else:
            content, path = file.read(), str(getattr(file, "name", "<text>"))
        parse_content = xml_file.parse if content.lstrip().startswith("<") else yaml_file.parse
        return parse_content(content, path), cls()

    def parse_substitution(self, value: Any) -> list[Substitution]:
        """Return the substitutions that a text contains. Plain parts become `TextSubstitution`."""
        return parse(str(value).lower() if isinstance(value, bool) else str(value))

    def parse_if_substitutions(self, value: Any) -> Any:
        """Parse a text, or each text of a list. See `substitution_text.parse_if_substitutions`."""
        return parse_if_substitutions(value)

    def escape_characters(self, value: str) -> str:
        """Return a text with escapes, so that `parse_substitution` reads it as plain text."""
        return value.replace("\\", "\\\\").replace("$", "\\$")

    def parse_description(self, entity: Entity) -> LaunchDescription:
        """Return the launch description of the outermost entity.

        Raises:
            LaunchFileError: The file is invalid.
        """
        if entity.type_name != _ROOT:
            raise entity.error(f"the outermost tag must be <launch>, not <{entity.type_name}>")
        entity.text("version")
        reason = entity.text("deprecated")
        description = LaunchDescription(self.actions(entity), deprecated_reason=reason)
        entity.assert_entity_completely_parsed()
        return description

    def actions(self, entity: Entity) -> list[LaunchDescriptionEntity]:
        """Return the actions inside an entity."""
        return [self.parse_action(child) for child in entity.children]

    def parse_action(self, entity: Entity) -> LaunchDescriptionEntity:
        """Return the action of an entity.

        Raises:
            LaunchFileError: The entity is invalid.
        """
        name = entity.type_name.replace("-", "_")
        build = ACTIONS.get(entity.type_name) or ACTIONS.get(name)
        if build is None:
            hint = did_you_mean(name, ACTIONS)
            raise entity.error(f"there is no action `{entity.type_name}`", hint)
        try:
            condition = self.condition(entity)
            action = build(entity, self)
        except LaunchFileError:
            raise
        except (ZbotError, ValueError) as error:
            raise entity.error(str(error), getattr(error, "hint", "") or "") from error
        entity.assert_entity_completely_parsed()
        if isinstance(action, Action):
            action.origin = Origin(entity.path, entity.line)
            action.condition = condition or action.condition
        return action

    def condition(self, entity: Entity) -> Condition | None:
        """Return the condition of the attributes `if` and `unless`, or None without them."""
        positive, negative = entity.text("if"), entity.text("unless")
        if positive is not None and negative is not None:
            raise entity.error(f"`{entity.type_name}` has both 'if' and 'unless': use one")
        if positive is not None:
            return IfCondition(parse(positive))
        return None if negative is None else UnlessCondition(parse(negative))
