"""All checks of one package."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.package.manifest import ManifestError, read_manifest
from zbot.package.workspace import MANIFEST, package_name
from zbot_cli.packages.check.dependencies import check_dependencies
from zbot_cli.packages.check.entry_points import check_entry_points
from zbot_cli.packages.check.installation import check_installation
from zbot_cli.packages.check.interfaces import check_interfaces
from zbot_cli.packages.check.problem import Problem
from zbot_cli.packages.check.setup_files import check_setup_files
from zbot_cli.packages.check.subject import Subject

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
    subject = Subject(package_name(folder), folder, manifest)
    subject.read_sources()
    problems += subject.problems
    problems += check_entry_points(subject)
    problems += check_interfaces(subject)
    problems += check_installation(subject)
    problems += check_setup_files(subject)
    problems += check_dependencies(subject, known)
    return sorted(dict.fromkeys(problems), key=lambda one: (not one.is_error, one))
