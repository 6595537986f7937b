"""Where launch descriptions come from: files, in Python, XML or YAML."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.launch.description import LaunchDescription
from zbot.launch.errors import (
    EntityTypeError,
    LaunchFileError,
    LaunchFileNotFoundError,
    NoSourceError,
)
from zbot.launch.substitution import describe, normalize, perform

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType

_FORMATS = {".py": "python", ".xml": "xml", ".yaml": "yaml", ".yml": "yaml"}


def file_locals(path: Path) -> dict[str, str]:
    """Return the locals that say which launch file is being worked on."""
    is_a_word = len(path.parts) == 1 and not path.is_file()
    return {
        "current_launch_file_path": str(path),
        # launch puts what is no path, e.g. "<script>", in both
        "current_launch_file_directory": str(path if is_a_word else path.parent),
    }


class LaunchDescriptionSource:
    """A launch file, or a description that is there already.

    Args:
        launch_description: The description, if it is there already.
        location: The path of the file.
        method: How it was made, for people.
    """

    format = ""  #: `python`, `xml` or `yaml`; by the file's name if empty

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
        """Return the description; the file is read when it is first asked for.

        Raises:
            LaunchError: The file is not there, or makes no sense.
        """
        if self._description is None:
            if not self._location:
                raise NoSourceError
            self._description = load_launch_file(perform(context, self._location), self.format)
        return self._description

    def try_get_launch_description_without_context(
        self, including: str = ""
    ) -> LaunchDescription | None:
        """Return the description if no more than the file is needed, else None.

        Args:
            including: The path of the launch file that this one is named in.

        Raises:
            LaunchFileError: The file makes no sense.
        """
        if self._description is None:
            location = self.location_before_launch(including)
            if location is None:
                return None
            self._description = load_launch_file(location, self.format)
        return self._description

    def location_before_launch(self, including: str = "") -> str | None:
        """Return the path if it is known before the launch; see above."""
        from zbot.launch.context import LaunchContext  # noqa: PLC0415 - cycle

        context = LaunchContext()
        if including:
            context.extend_locals(file_locals(Path(including)))
        try:
            return perform(context, self._location)
        except (ZbotError, LookupError):
            return None  # it depends on what only the launch knows

    def path(self, context: LaunchContext) -> Path | None:
        """Return the absolute path of the file; None if there is no file."""
        location = perform(context, self._location)
        if not location:
            return None
        path = Path(location)
        return path.absolute() if path.is_file() or len(path.parts) > 1 else path

    @property
    def location(self) -> str:
        """The path, as far as it is known."""
        return self.location_before_launch() or ""

    @property
    def location_text(self) -> str:
        """The path as it was written, for people."""
        return describe(self._location)


def load_launch_file(location: str, kind: str = "") -> LaunchDescription:
    """Return what a launch file describes.

    Args:
        location: Its path.
        kind: `python`, `xml` or `yaml`; by the file's name if empty.

    Raises:
        LaunchFileNotFoundError: There is no such file.
        LaunchFileError: It makes no sense.
    """
    path = Path(location).absolute()
    if not path.is_file():
        raise LaunchFileNotFoundError(f"launch file '{location}' not found")
    kind = kind or _FORMATS.get(path.suffix, "")
    if kind == "python":
        from zbot.launch.python_file import load  # noqa: PLC0415 - read when needed

        return load(path)
    if kind in {"xml", "yaml"}:
        from zbot.launch.frontend import load_file  # noqa: PLC0415 - most files are Python

        return load_file(path, kind)
    reason = "the name of a launch file ends in .py, .xml, .yaml or .yml"
    raise LaunchFileError(str(path), 0, reason)


def load_python_launch_file(location: str) -> LaunchDescription:
    """Return what a launch file in Python describes, whatever its name; see above."""
    return load_launch_file(location, "python")


class AnyLaunchDescriptionSource(LaunchDescriptionSource):
    """A launch file of any format."""

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, f"interpreted {self.format or 'any'} launch file")


class PythonLaunchDescriptionSource(AnyLaunchDescriptionSource):
    """A launch file in Python, whatever its name."""

    format = "python"


class FrontendLaunchDescriptionSource(AnyLaunchDescriptionSource):
    """A launch file in XML or YAML."""


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """A launch file in XML, whatever its name."""

    format = "xml"


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """A launch file in YAML, whatever its name."""

    format = "yaml"
