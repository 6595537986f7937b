"""Sources of launch descriptions: files in Python, XML or YAML."""

from __future__ import annotations

import codecs
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.errors.suggestion import correction
from zbot.launch.description import LaunchDescription
from zbot.launch.errors import (
    EntityTypeError,
    LaunchFileError,
    LaunchFileNotFoundError,
    LaunchUsageError,
    TemplateError,
)
from zbot.launch.substitution import describe, normalize, perform
from zbot.package.absent import absent_packages_reported

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType

_TEMPLATE = ".in"
_FORMATS = {".py": "python", ".xml": "xml", ".yaml": "yaml", ".yml": "yaml"}


def file_locals(path: Path) -> dict[str, str]:
    """Return the locals that contain the path and the folder of the present launch file."""
    is_a_word = len(path.parts) == 1 and not path.is_file()
    return {
        "current_launch_file_path": str(path),
        # As in ROS 2's launch, a text that is not a path, e.g. "<script>", stays unchanged.
        "current_launch_file_directory": str(path if is_a_word else path.parent),
    }


class LaunchDescriptionSource:
    """Source of a launch description, which is a file or an existing description.

    Args:
        launch_description: The description, if it exists already.
        location: The path of the file.
        method: A readable text that tells how the source was created.
    """

    format = ""  #: `python`, `xml` or `yaml`. If empty, the file's suffix decides.

    def __init__(
        self,
        launch_description: LaunchDescription | None = None,
        location: SomeSubstitutionsType = "",
        method: str = "unspecified mechanism from a script",
    ) -> None:
        if launch_description is not None and not isinstance(launch_description, LaunchDescription):
            raise EntityTypeError("launch_description", "a LaunchDescription", launch_description)
        self._description = launch_description
        self._location = normalize(location) if location else []
        self.method = method

    def get_launch_description(self, context: LaunchContext) -> LaunchDescription:
        """Return the description. The first call reads the file.

        Raises:
            LaunchError: The file does not exist or is invalid.
        """
        if self._description is None:
            if not self._location:
                text = "this source has neither a launch description nor the path of a file"
                raise LaunchUsageError(text)
            self._description = load_launch_file(perform(context, self._location), self.format)
        return self._description

    def try_get_launch_description_without_context(
        self, including: str = ""
    ) -> LaunchDescription | None:
        """Return the description. Return None if its path is not known before the launch.

        Args:
            including: The path of the launch file that includes this file.

        Raises:
            LaunchFileError: The file is invalid.
        """
        if self._description is None:
            location = self.location_before_launch(including)
            if location is None:
                return None
            with absent_packages_reported():
                self._description = load_launch_file(location, self.format)
        return self._description

    def location_before_launch(self, including: str = "") -> str | None:
        """Return the path. Return None if the path is not known before the launch."""
        from zbot.launch.context import LaunchContext  # noqa: PLC0415 - cycle

        context = LaunchContext()
        if including:
            context.extend_locals(file_locals(Path(including)))
        try:
            return perform(context, self._location)
        except (ZbotError, LookupError):
            return None  # the path depends on values that exist only during the launch

    def path(self, context: LaunchContext) -> Path | None:
        """Return the absolute path of the file. Return None if the source has no location."""
        location = perform(context, self._location)
        if not location:
            return None
        path = Path(location)
        return path.absolute() if path.is_file() or len(path.parts) > 1 else path

    @property
    def location(self) -> str:
        """The path, or an empty text if the path is known only during the launch."""
        return self.location_before_launch() or ""

    @property
    def location_text(self) -> str:
        """The path with its substitutions, as readable text."""
        return describe(self._location)


def load_launch_file(location: str, kind: str = "") -> LaunchDescription:
    """Return the launch description of a launch file.

    Args:
        location: The path of the file.
        kind: `python`, `xml` or `yaml`. If empty, the file's suffix decides. With another suffix,
            e.g. `.launch`, the file's content decides.

    Raises:
        TemplateError: The file is the template of a launch file, or only its template exists.
        LaunchFileNotFoundError: The file does not exist.
        LaunchFileError: The file is invalid.
    """
    path = Path(location).absolute()
    check_template(path)
    if not path.is_file():
        hint = correction(path.name, (file.name for file in path.parent.glob("*")))
        raise LaunchFileNotFoundError(f"launch file '{location}' not found", hint)
    kind = kind or _FORMATS.get(path.suffix, "")
    if kind == "python":
        return _load_python(path)
    if kind in {"xml", "yaml"}:
        from zbot.launch.frontend import load_file  # noqa: PLC0415 - most files are Python

        return load_file(path, kind)
    return _load_unknown(path)


def check_template(path: Path) -> None:
    """Refuse a path if it is the template of a launch file, or if only its template exists.

    Raises:
        TemplateError: The package's build makes the launch file from the template.
    """
    template = path if path.suffix == _TEMPLATE else Path(f"{path}{_TEMPLATE}")
    is_of_launch_file = template.with_suffix("").suffix in {*_FORMATS, ".launch"}
    if is_of_launch_file and template.is_file() and (path == template or not path.exists()):
        raise TemplateError(template)


def _load_python(path: Path) -> LaunchDescription:
    from zbot.launch.python_file import load  # noqa: PLC0415 - loaded when used

    return load(path)


def _load_unknown(path: Path) -> LaunchDescription:
    """Return the description of a file whose suffix, e.g. `.launch`, does not tell the format."""
    from zbot.launch.errors import InvalidFrontendLaunchFileError  # noqa: PLC0415 - as above
    from zbot.launch.frontend import load_file, yaml_file  # noqa: PLC0415 - few files need it

    if path.read_bytes().removeprefix(codecs.BOM_UTF8).lstrip().startswith(b"<"):
        return load_file(path, "xml")  # such a text is neither YAML nor Python
    try:
        yaml_file.load(path)
    except InvalidFrontendLaunchFileError as error:
        return _load_python_or_explain(path, error)
    return load_file(path, "yaml")


def _load_python_or_explain(path: Path, yaml_error: LaunchFileError) -> LaunchDescription:
    try:
        return _load_python(path)
    except LaunchFileError as error:
        if not isinstance(error.__cause__, (SyntaxError, ValueError)):
            raise
        found = "; ".join(
            f"{language}: line {found_error.line}: {found_error.reason}"
            for language, found_error in (("YAML", yaml_error), ("Python", error))
        )
        reason = f"its text is not a launch file in XML, YAML or Python ({found})"
        raise LaunchFileError(str(path), 0, reason) from error


def load_python_launch_file(location: str) -> LaunchDescription:
    """Return the description of a launch file in Python, which may have any suffix."""
    return load_launch_file(location, "python")


class AnyLaunchDescriptionSource(LaunchDescriptionSource):
    """A launch file in any format."""

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, f"interpreted {self.format or 'any'} launch file")


class PythonLaunchDescriptionSource(AnyLaunchDescriptionSource):
    """A launch file in Python, with any suffix."""

    format = "python"


class FrontendLaunchDescriptionSource(AnyLaunchDescriptionSource):
    """A launch file in XML or YAML."""


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """A launch file in XML, with any suffix."""

    format = "xml"


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """A launch file in YAML, with any suffix."""

    format = "yaml"
