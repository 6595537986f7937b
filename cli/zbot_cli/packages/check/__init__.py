"""Checks that find the errors of a package before it runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.package.manifest import ManifestError, read_manifest
from zbot.package.workspace import MANIFEST, package_name
from zbot_cli.packages.check.checked_package import CheckedPackage, Problem
from zbot_cli.packages.check.dependencies import check_dependencies
from zbot_cli.packages.check.entry_points import check_entry_points
from zbot_cli.packages.check.installation import check_installation
from zbot_cli.packages.check.interfaces import check_interfaces
from zbot_cli.packages.check.setup_files import check_setup_files

if TYPE_CHECKING:
    from collections.abc import Container
    from pathlib import Path


def check_package(folder: Path, known: Container[str]) -> list[Problem]:
    """Return the problems of a package, errors first.

    Args:
        folder: The folder of the package.
        known: Names of the packages that must be declared if they are imported.
    """
    problems: list[Problem] = []
    manifest = None
    if (folder / MANIFEST).is_file():
        try:
            manifest = read_manifest(folder / MANIFEST)
        except ManifestError as error:
            problems.append(Problem(error.path, error.line, error.reason))
    checked = CheckedPackage(package_name(folder), folder, manifest)
    checked.read_sources()
    problems += checked.problems
    problems += check_entry_points(checked)
    problems += check_interfaces(checked)
    problems += check_installation(checked)
    problems += check_setup_files(checked)
    problems += check_dependencies(checked, known)
    return sorted(dict.fromkeys(problems), key=lambda problem: (not problem.is_error, problem))
