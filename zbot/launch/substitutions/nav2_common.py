"""Substitutions of Nav2's package nav2_common, which change files before nodes read them."""

from __future__ import annotations

import sys
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.launch.errors import SubstitutionError
from zbot.launch.parameters import temporary_file
from zbot.launch.substitution import Substitution, describe, normalize, perform, to_bool
from zbot.launch.substitutions.value import FileContent, LaunchConfiguration
from zbot.text.yaml_reader import YamlError, read_yaml

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping

    from zbot.launch.condition import Condition
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType

    Texts = Mapping[str, SomeSubstitutionsType]
    #: A value in YAML: its path with dots, its key (None in a list), itself, and how to replace it.
    Place = tuple[str, Any, Any, Callable[[Any], None]]

_PARAMETERS = "ros__parameters"
_POSE = ("x", "y", "z", "roll", "pitch", "yaw")


class _FileSubstitution(Substitution):
    """Substitution that reads a file."""

    def __init__(self, source_file: SomeSubstitutionsType) -> None:
        self._source_file = normalize(source_file)

    @property
    def name(self) -> list[Substitution]:
        """The path of the file."""
        return self._source_file

    def describe(self) -> str:
        """Return the class and the path."""
        return f"{type(self).__name__}({describe(self.name)})"

    def text(self, context: LaunchContext) -> str:
        """Return the content of the file.

        Raises:
            SubstitutionError: The file cannot be read.
        """
        return FileContent(self.name).perform(context)

    def yaml(self, context: LaunchContext) -> Any:
        """Return the value in the file.

        Raises:
            SubstitutionError: The file cannot be read, or it is not YAML.
        """
        try:
            return read_yaml(self.text(context))
        except YamlError as error:
            path = perform(context, self.name)
            raise SubstitutionError(f"cannot read '{path}': {error}") from error


class RewrittenYaml(_FileSubstitution):
    """The path of a changed copy of a YAML file. The end of the launch removes the copy.

    Args:
        source_file: The file with parameters.
        param_rewrites: New values. A key is the name of a parameter, which is changed everywhere
            in the file, or a whole path such as `amcl.ros__parameters.alpha1`. A whole path with
            `ros__parameters` is added if it is not in the file.
        root_key: Key under which the whole content is put, for example a namespace.
        key_rewrites: New names of keys.
        value_rewrites: New values, by the text of the old value.
        convert_types: Whether texts that are numbers become numbers. The texts `true` and `false`
            always become truth values.
        out_dir: The folder of the copy. None means the system's folder of temporary files.
    """

    def __init__(  # noqa: PLR0917 - nav2_common's signature
        self,
        source_file: SomeSubstitutionsType,
        param_rewrites: Texts,
        root_key: SomeSubstitutionsType | None = None,
        key_rewrites: Texts | None = None,
        value_rewrites: Texts | None = None,
        convert_types: bool = False,
        out_dir: SomeSubstitutionsType | None = None,
    ) -> None:
        super().__init__(source_file)
        self._params = _normalized(param_rewrites or {})  # also `""`, as launch files of Nav2 write
        self._root_key = [] if root_key is None else normalize(root_key)
        self._keys = _normalized(key_rewrites or {})
        self._values = _normalized(value_rewrites or {})
        self._is_converting = convert_types
        self._out_dir = [] if out_dir is None else normalize(out_dir)

    def perform(self, context: LaunchContext) -> str:
        """Write the copy, and return its path.

        Raises:
            SubstitutionError: The file cannot be read, or the copy cannot be written.
        """
        import yaml  # noqa: PLC0415 - most launches write no YAML

        content = self.yaml(context)
        content = {} if content is None else content
        if not isinstance(content, dict):
            path = perform(context, self.name)
            raise SubstitutionError(f"'{path}' has no names with values, so it has no parameters")
        self._rewrite(content, _performed(context, self._params))
        content = _renamed(content, _performed(context, self._keys))
        values = _performed(context, self._values)
        for _, _, value, replace in _places(content):
            if not isinstance(value, (dict, list)) and str(value) in values:
                replace(self._converted(values[str(value)]))
        root_key = perform(context, self._root_key)
        text = yaml.safe_dump({root_key: content} if root_key else content)
        return _written(context, text, perform(context, self._out_dir))

    def _rewrite(self, content: dict[Any, Any], rewrites: Mapping[str, str]) -> None:
        replaced = set()
        for path, name, value, replace in list(_places(content)):
            if path in rewrites and not isinstance(value, (dict, list)):
                replaced.add(path)
                replace(self._converted(rewrites[path]))
            elif name in rewrites:
                replace(self._converted(rewrites[name]))
        for path, text in rewrites.items():
            if path not in replaced and _PARAMETERS in path.split("."):
                _set(content, path.split("."), self._converted(text))

    def _converted(self, text: str) -> Any:
        if self._is_converting:
            try:
                return float(text) if "." in text else int(text)
            except ValueError:
                pass
        return {"true": True, "false": False}.get(text.lower(), text)


def _normalized(texts: Texts) -> dict[str, list[Substitution]]:
    return {key: normalize(text) for key, text in texts.items()}


def _performed(context: LaunchContext, texts: Texts) -> dict[str, str]:
    return {key: perform(context, text) for key, text in texts.items()}


def _places(content: Any, prefix: str = "") -> Iterator[Place]:
    """Return the places in dictionaries and lists. A container comes after its items."""
    is_list = isinstance(content, list)
    for key, value in list(enumerate(content) if is_list else content.items()):
        path = f"{prefix}{key}"
        if isinstance(value, (dict, list)):
            yield from _places(value, f"{path}.")
        yield path, None if is_list else key, value, partial(content.__setitem__, key)


def _set(content: dict[Any, Any], keys: list[str], value: Any) -> None:
    """Set the value at a path. Missing dictionaries are added."""
    inner: Any = content
    for key in keys[:-1]:
        if isinstance(inner, list):
            inner = inner[int(key)]
            continue
        if not isinstance(inner.get(key), (dict, list)):
            inner[key] = {}
        inner = inner[key]
    inner[int(keys[-1]) if isinstance(inner, list) else keys[-1]] = value


def _renamed(content: Any, names: Mapping[str, str]) -> Any:
    if not isinstance(content, dict):
        return content
    return {names.get(key, key): _renamed(value, names) for key, value in content.items()}


def _written(context: LaunchContext, text: str, folder: str = "") -> str:
    try:
        return str(temporary_file(context, text, folder or None))
    except OSError as error:
        where = folder or "the folder of temporary files"
        raise SubstitutionError(f"cannot write into {where}: {error.strerror}") from error


class ReplaceString(_FileSubstitution):
    """The path of a copy of a file with other texts. The end of the launch removes the copy.

    Args:
        source_file: The file.
        replacements: New texts, by the texts to replace.
        condition: If it is false, the path is that of the file itself.
    """

    def __init__(
        self,
        source_file: SomeSubstitutionsType,
        replacements: Texts,
        condition: Condition | None = None,
    ) -> None:
        super().__init__(source_file)
        self._replacements = _normalized(replacements)
        self.condition = condition

    def perform(self, context: LaunchContext) -> str:
        """Write the copy, and return its path.

        Raises:
            SubstitutionError: The file cannot be read, or the copy cannot be written.
        """
        if self.condition is not None and not self.condition.evaluate(context):
            return perform(context, self.name)
        text = self.text(context)
        for old, new in _performed(context, self._replacements).items():
            text = text.replace(old, new)
        return _written(context, text)


class HasNodeParams(_FileSubstitution):
    """`True` if a file with parameters has a section for a node, otherwise `False`.

    Args:
        source_file: The file.
        node_name: The key of the section.
    """

    def __init__(self, source_file: SomeSubstitutionsType, node_name: str) -> None:
        super().__init__(source_file)
        self._node_name = node_name

    def perform(self, context: LaunchContext) -> str:
        """Read the file, and return `True` or `False`.

        Raises:
            SubstitutionError: The file cannot be read, or it is not YAML.
        """
        content = self.yaml(context)
        return str(isinstance(content, dict) and self._node_name in content)


class LaunchConfigAsBool(Substitution):
    """`True` if a launch argument is `true`, `1`, `yes` or `on`, otherwise `False`."""

    def __init__(self, name: str) -> None:
        self._argument = LaunchConfiguration(name)

    def perform(self, context: LaunchContext) -> str:
        """Return `True` or `False`."""
        return str(to_bool(perform(context, self._argument)) is True)

    def describe(self) -> str:
        """Return the class and the argument."""
        return f"LaunchConfigAsBool({self._argument.describe()})"


class ParseMultiRobotPose:
    """Poses of robots in a word of the command line, `robots:="a={x: 1.0}; b={yaw: 1.5}"`.

    Args:
        target_argument: The name of the launch argument, e.g. `robots`.
    """

    def __init__(self, target_argument: str) -> None:
        start = f"{target_argument}:="
        words = (word for word in sys.argv[1:] if word.startswith(start))
        self._text = next(words, start)[len(start) :]

    def value(self) -> dict[str, dict[str, Any]]:
        """Return the poses by the names of the robots. Missing numbers are 0.

        Raises:
            SubstitutionError: A pose is not a dictionary in YAML.
        """
        poses = {}
        for part in self._text.split(";"):
            name, sign, text = (word.strip() for word in part.partition("="))
            if sign and "=" not in text:
                poses[name] = dict.fromkeys(_POSE, 0.0) | _pose(text)
        return poses


def _pose(text: str) -> dict[str, Any]:
    try:
        pose = read_yaml(text)
    except YamlError:
        pose = None
    if not isinstance(pose, dict):
        raise SubstitutionError(f"a pose must look like {{x: 1.0, y: 2.0, yaw: 0.5}}, not '{text}'")
    return pose
