"""Functions of ros2cli's Python packages about packages and their files."""

from __future__ import annotations

from zbot.errors import ZbotError
from zbot.package import PackageNotFoundError, package_prefix, package_share, packages
from zbot.package.symlink_install import files_below


class MultipleLaunchFilesError(ZbotError):
    """Several files of a package have the name that was asked for."""

    def __init__(self, msg: str, paths: list[str]) -> None:
        self.paths = paths
        super().__init__(msg)


def get_share_file_path_from_package(*, package_name: str, file_name: str) -> str:
    """Return the path of a file in the share folder of a package, or in a folder below it.

    Raises:
        PackageNotFoundError: There is no such package.
        FileNotFoundError: The package has no such file.
        MultipleLaunchFilesError: Several files of the package have this name.
    """
    share = package_share(package_name)
    found = sorted(str(path) for path in files_below(share) if path.name == file_name)
    if not found:
        raise FileNotFoundError(f"the package '{package_name}' has no file '{file_name}': {share}")
    if len(found) > 1:
        text = f"the package '{package_name}' has several files '{file_name}': {', '.join(found)}"
        raise MultipleLaunchFilesError(text, found)
    return found[0]


def get_prefix_path(package_name: str) -> str | None:
    """Return the prefix of a package, or None if there is no such package."""
    try:
        return str(package_prefix(package_name))
    except PackageNotFoundError:
        return None


def get_package_names() -> list[str]:
    """Return the names of all packages."""
    return sorted(packages())
