"""Verbs of `zbot pkg`: list packages and their executables, and create packages."""

from __future__ import annotations

import sys
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, ClassVar

import typer

from zbot.errors.suggestion import correction
from zbot.package import PackageNotFoundError, package_prefix, package_share, packages
from zbot.package.finder import BUNDLED_NAMES, find_package
from zbot.package.workspace import (
    MANIFEST,
    current_workspace,
    package_folders,
    package_name,
    packages_by_name,
)
from zbot_cli.commands.run.executable_search import package_not_found_error
from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import AsJson, new_app, print_json
from zbot_cli.packages import executables
from zbot_cli.packages.check import check_package
from zbot_cli.packages.check.checked_package import shown_path
from zbot_cli.packages.creation import Plan, create, known_licenses, user_email, user_name
from zbot_cli.packages.executables import Executable, all_packages, program_file
from zbot_cli.packages.known_workspaces import remember

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from zbot_cli.packages.check.checked_package import Problem
    from zbot_cli.packages.missing_dependencies import MissingDependency

app = new_app("Find and create packages")

PackageName = Annotated[str, typer.Argument(help="Name of the package")]


def no_package_error(name: str, hint: str) -> CommandError:
    """Return the error that there is no package of that name."""
    return CommandError("Package not found", hint=hint, package=name)


def tag_not_found_error(tag: str, known: list[str]) -> CommandError:
    """Return the error that a manifest has no such tag."""
    hint = f"package.xml has the tags {', '.join(known)}"
    return CommandError("XML tag not found", hint=hint)


class BuildType(str, Enum):
    """Build types of ROS 2."""

    AMENT_PYTHON = "ament_python"
    AMENT_CMAKE = "ament_cmake"
    CMAKE = "cmake"


class _CreateCommand(ManyValuesCommand):
    many: ClassVar[frozenset[str]] = frozenset({"--dependencies"})


@app.command("create", cls=_CreateCommand)
def create_package(
    package_name: Annotated[str, typer.Argument(help="Name of the new package")] = "",
    package_format: Annotated[
        int,
        typer.Option(
            "--package-format", "--package_format", min=2, max=3, help="Format of package.xml"
        ),
    ] = 3,
    description: Annotated[
        str, typer.Option("--description", help="What the package is for")
    ] = "TODO: Package description",
    license_name: Annotated[
        str,
        typer.Option(
            "--license", help="SPDX identifier; '?' lists the licenses whose text zbot has"
        ),
    ] = "TODO: License declaration",
    destination_directory: Annotated[
        str, typer.Option("--destination-directory", help="Folder to create the package in")
    ] = ".",
    build_type: Annotated[
        BuildType, typer.Option("--build-type", help="Build type of ROS 2")
    ] = BuildType.AMENT_PYTHON,
    dependencies: Annotated[
        list[str] | None, typer.Option("--dependencies", help="Packages that it depends on")
    ] = None,
    maintainer_email: Annotated[
        str, typer.Option("--maintainer-email", help="E-mail address of the maintainer")
    ] = "",
    maintainer_name: Annotated[
        str, typer.Option("--maintainer-name", help="Name of the maintainer")
    ] = "",
    node_name: Annotated[
        str, typer.Option("--node-name", help="Add a program with this name")
    ] = "",
    library_name: Annotated[
        str, typer.Option("--library-name", help="Add a library with this name")
    ] = "",
    has_vscode: Annotated[
        bool, typer.Option("--vscode", help="Add a folder .vscode: tasks, and ways to start nodes")
    ] = False,
) -> None:
    """Create a new package."""
    if license_name == "?":
        print("Supported licenses:", *known_licenses(), sep="\n")
        return
    if not package_name:
        raise typer.BadParameter(
            "name the new package, e.g. zbot pkg create my_package", param_hint="'PACKAGE_NAME'"
        )
    maintainer = maintainer_name or user_name()
    plan = Plan(
        name=package_name,
        destination=destination_directory,
        build_type=build_type.value,
        package_format=package_format,
        description=description,
        license=license_name,
        maintainer=maintainer,
        email=maintainer_email or user_email(maintainer),
        dependencies=tuple(dependencies or ()),
        node=_distinct(node_name, library_name),
        library=library_name,
        has_vscode=has_vscode,
    )
    create(plan)
    remember(current_workspace())
    if license_name not in known_licenses():
        _warn_of_license(license_name)
    if plan.node and build_type is not BuildType.AMENT_PYTHON:
        print("\nhint: a C++ package needs ROS 2; zbot runs Python programs only", file=sys.stderr)


def _distinct(node: str, library: str) -> str:
    if not node or node != library:
        return node
    print("[WARNING] node name can not be equal to the library name", file=sys.stderr)
    print(f"[WARNING] renaming node to {node}_node", file=sys.stderr)
    return f"{node}_node"


def _warn_of_license(name: str) -> None:
    print(
        f"\n[WARNING]: Unknown license '{name}'.  This has been set in the package.xml, but no "
        "LICENSE file has been created.\nIt is recommended to use one of the ament license "
        "identifiers:",
        *known_licenses(),
        sep="\n",
    )


@app.command("list")
def list_packages(as_json: AsJson = False) -> None:
    """List all packages."""
    found = packages()
    bundled = [package.name for package in executables.bundled_packages()]
    if as_json:
        keys = ("name", "origin", "folder")
        rows = [
            (package.name, package.origin.value, str(package.folder)) for package in found.values()
        ]
        print_json([dict(zip(keys, row, strict=True)) for row in rows])
        return
    print(*sorted({*found, *bundled}), sep="\n")


@app.command("check")
def check(
    package_names: Annotated[
        list[str] | None, typer.Argument(help="Check only these packages")
    ] = None,
) -> int:
    """Check packages of the workspace for mistakes."""
    folders = {package_name(folder): folder for folder in package_folders()}
    known = {*packages(), *folders}.difference(BUNDLED_NAMES)
    problems: list[Problem] = []
    for name in package_names or sorted(folders):
        if name not in folders:
            raise package_not_found_error(name, sorted(folders))
        problems += check_package(folders[name], known - {name})
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return Status.ERROR if any(problem.is_error for problem in problems) else Status.OK


@app.command("executables")
def list_executables(
    package_name: Annotated[str, typer.Argument(help="List only this package's executables")] = "",
    full_path: Annotated[bool, typer.Option("--full-path", help="Print paths of files")] = False,
    as_json: AsJson = False,
) -> None:
    """List the executables of packages."""
    found = _executables(package_name)
    if as_json:
        rows = [
            (executable.package, executable.name, program_file(executable)) for executable in found
        ]
        keys = ("package", "executable", "file")
        print_json([dict(zip(keys, row, strict=True)) for row in rows])
        return
    for executable in found:
        print(program_file(executable) if full_path else f"{executable.package} {executable.name}")


def _executables(name: str) -> list[Executable]:
    everywhere = all_packages()
    inside = [package for package in everywhere if name in {"", package.name}]
    if not inside and not find_package(name):
        inside = executables.installed_package(name)
        if not inside:
            raise package_not_found_error(name, sorted({package.name for package in everywhere}))
    # If several packages have the same name, the first package is used.
    first = {package.name: package for package in reversed(inside)}
    return sorted(executable for package in first.values() for executable in package.executables)


@app.command("deps")
def dependencies(
    package_names: Annotated[
        list[str] | None,
        typer.Argument(metavar="[PACKAGE]...", help="Look only at these packages"),
    ] = None,
    as_json: AsJson = False,
) -> int:
    """Show which packages are missing."""
    import zbot.compat  # noqa: F401, PLC0415 - its packages, such as rclpy, are here
    from zbot_cli.packages.missing_dependencies import OTHER, missing_dependencies  # noqa: PLC0415 - slow to import

    folders = {name: places[0] for name, places in packages_by_name().items()}
    unknown = [name for name in package_names or () if name not in folders]
    if unknown:
        raise package_not_found_error(unknown[0], sorted(folders))
    chosen = [folders[name] for name in package_names or folders]
    missing = missing_dependencies(chosen, folders)
    if as_json:
        keys = ("name", "kind", "file", "line", "get")
        rows = [
            (
                dependency.name,
                dependency.kind,
                str(dependency.path),
                dependency.line,
                dependency.get,
            )
            for dependency in missing
        ]
        print_json([dict(zip(keys, row, strict=True)) for row in rows])
    else:
        _print_missing(missing, len(chosen))
    return Status.ERROR if any(dependency.kind != OTHER for dependency in missing) else Status.OK


def _print_missing(missing: list[MissingDependency], count: int) -> None:
    titles = {
        "message": "Missing message packages and types:",
        "python": "Missing Python packages:",
    }
    for kind, title in titles.items():
        listed = [dependency for dependency in missing if dependency.kind == kind]
        if listed:
            print(title)
        for dependency in listed:
            place = f"{shown_path(dependency.path)}:{dependency.line}"
            print(f"  {dependency.name}  ({place})\n      {dependency.get}")
    if not any(dependency.kind in titles for dependency in missing):
        print(f"No message or Python package is missing in {count} package{'s' * (count != 1)}.")
    others: dict[str, list[str]] = {}
    for dependency in missing:
        if dependency.kind not in titles:
            others.setdefault(dependency.get, []).append(dependency.name)
    if others:
        print("Other packages that package.xml names and that are not here:")
    for reason, names in sorted(others.items()):
        print(f"  {', '.join(names)}{reason and f': {reason}'}")


@app.command("prefix")
def prefix(
    package_name: PackageName,
    share: Annotated[bool, typer.Option("--share", help="Print its share folder")] = False,
) -> None:
    """Print the folder that a package is in."""
    find = package_share if share else package_prefix
    try:
        print(find(package_name))
    except PackageNotFoundError as error:
        raise no_package_error(package_name, error.hint) from error


@app.command("xml")
def xml(
    package_name: PackageName,
    tag: Annotated[str, typer.Option("-t", "--tag", help="Print only the text of this tag")] = "",
) -> None:
    """Print a package's manifest, or one tag."""
    from zbot.package.manifest import read_tree  # noqa: PLC0415 - needed only by this verb

    package = find_package(package_name)
    if package is None:
        raise no_package_error(package_name, correction(package_name, packages()))
    path = package.folder / MANIFEST
    if not path.is_file():
        raise CommandError("Package XML manifest not found")
    root = read_tree(path)
    if not tag:
        print(_text(path, root).rstrip("\n"))
        return
    texts = ["".join(element.itertext()).strip() for element in root.iter(tag)]
    if not texts:
        raise tag_not_found_error(tag, sorted({element.tag for element in root.iter()}))
    print(*texts, sep="\n")


def _text(path: Path, root: Element) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:  # the first line of the file names another encoding
        from xml.etree.ElementTree import tostring  # noqa: PLC0415 - needed by few files

        return tostring(root, encoding="unicode")
