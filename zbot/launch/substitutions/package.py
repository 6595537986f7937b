"""Where packages are, and their programs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.launch.own_command import program_file
from zbot.launch.substitution import Substitution, describe, normalize, perform
from zbot.package import package_prefix, package_share

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


class FindPackagePrefix(Substitution):
    """The folder that a package is installed to."""

    def __init__(self, package: SomeSubstitutionsType) -> None:
        self.package = normalize(package)

    def perform(self, context: LaunchContext) -> str:
        """Return the folder.

        Raises:
            PackageNotFoundError: There is no such package.
        """
        return self.find(perform(context, self.package))

    def find(self, package_name: str) -> str:
        """Return the folder of any package, with no launch running.

        Raises:
            PackageNotFoundError: There is no such package.
        """
        return str(package_prefix(package_name))

    def describe(self) -> str:
        """Return the package."""
        return f"{type(self).__name__}(pkg={describe(self.package)})"


FindPackage = FindPackagePrefix


class FindPackageShare(FindPackagePrefix):
    """The folder with what a package shares: `launch`, `config` and the like."""

    def find(self, package_name: str) -> str:
        """Return the folder of any package, with no launch running.

        Raises:
            PackageNotFoundError: There is no such package.
        """
        return str(package_share(package_name))


class ExecutableInPackage(FindPackagePrefix):
    """The path of a program that runs an executable of a package."""

    def __init__(self, executable: SomeSubstitutionsType, package: SomeSubstitutionsType) -> None:
        super().__init__(package)
        self.executable = normalize(executable)

    def perform(self, context: LaunchContext) -> str:
        """Return the path."""
        package, executable = perform(context, self.package), perform(context, self.executable)
        if context.find_program is not None:
            context.find_program(package, executable)
        return str(program_file(package, executable))
