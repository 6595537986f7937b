"""Substitutions for the folders and executables of packages."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.substitution import Substitution, describe, normalize, perform
from zbot.package import package_prefix, package_share
from zbot.package.zbot_command import executable_wrapper

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class FindPackagePrefix(Substitution):
    """The install prefix of a package."""

    def __init__(self, package: SomeSubstitutionsType) -> None:
        self.package = normalize(package)

    def perform(self, context: LaunchContext) -> str:
        """Return the folder.

        Raises:
            PackageNotFoundError: The package does not exist.
        """
        return self.find(perform(context, self.package))

    def find(self, package_name: str) -> str:
        """Return the folder of a package. Any program may call this, also without a launch.

        Raises:
            PackageNotFoundError: The package does not exist.
        """
        return str(package_prefix(package_name))

    def describe(self) -> str:
        """Return the package."""
        return f"{type(self).__name__}(pkg={describe(self.package)})"


FindPackage = FindPackagePrefix


class FindPackageShare(FindPackagePrefix):
    """The share folder of a package, which contains `launch`, `config` and similar folders."""

    def find(self, package_name: str) -> str:
        """Return the folder of a package. Any program may call this, also without a launch.

        Raises:
            PackageNotFoundError: The package does not exist.
        """
        return str(package_share(package_name))


class ExecutableInPackage(FindPackagePrefix):
    """The path of a wrapper program that runs an executable of a package."""

    def __init__(self, executable: SomeSubstitutionsType, package: SomeSubstitutionsType) -> None:
        super().__init__(package)
        self.executable = normalize(executable)

    def perform(self, context: LaunchContext) -> str:
        """Return the path."""
        package, executable = perform(context, self.package), perform(context, self.executable)
        if context.find_program is not None:
            context.find_program(package, executable)
        return str(executable_wrapper(package, executable))
