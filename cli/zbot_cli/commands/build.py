"""`zbot build`: checks packages for errors before they run. It builds nothing.

It writes `install/setup.bash`, because lessons tell students to type `source install/setup.bash`
after a build.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import typer

from zbot.errors import counted
from zbot.errors.suggestion import question, similar_names
from zbot.package import packages
from zbot.package.finder import BUNDLED_NAMES
from zbot.package.manifest import ManifestError, read_manifest
from zbot.package.workspace import (
    MANIFEST,
    build_roots,
    package_folders,
    package_name,
)
from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import new_app
from zbot_cli.packages.check import check_package
from zbot_cli.packages.known_workspaces import remember, workspace_folder
from zbot_cli.packages.setup_scripts import source_line, write_setup_scripts

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot_cli.packages.check.checked_package import Problem

app = new_app("Check packages; nothing needs building", has_verbs=False)

#: Options of colcon that have no effect here: options without a value, with one value, and with
#: many values.
_FLAGS = frozenset({
    "--symlink-install", "--merge-install", "--continue-on-error", "--cmake-clean-cache",
    "--cmake-clean-first", "--cmake-force-configure", "--cmake-target-skip-unavailable",
    "--packages-skip-build-finished", "--packages-skip-test-passed", "--test-result-ignore",
})  # fmt: skip
_WITH_WORD = frozenset({
    "--build-base", "--install-base", "--test-result-base", "--parallel-workers", "--executor",
    "--cmake-target", "--log-level", "--log-base",
})  # fmt: skip
_WITH_WORDS = frozenset({
    "--cmake-args", "--ament-cmake-args", "--catkin-cmake-args", "--event-handlers",
    "--allow-overriding", "--metas", "--mixin",
})  # fmt: skip


def unknown_packages_error(option: str, names: list[str], known: Iterable[str]) -> CommandError:
    """Return the error that an option contains packages that are not in the workspace."""
    guesses = question(near for name in names for near in similar_names(name, known))
    there = ", ".join(sorted(known)) or "none"
    hint = guesses or f"the packages here are: {there}"
    quoted = ", ".join(f"'{name}'" for name in names)
    return CommandError(f"unknown package{'s' * (len(names) > 1)} {quoted} in {option}", hint=hint)


def duplicate_packages_error(found: dict[str, list[Path]]) -> CommandError:
    """Return the error that several folders contain packages of the same name."""
    lines = "".join(
        f"\n- {name}:" + "".join(f"\n  - {folder}" for folder in folders)
        for name, folders in sorted(found.items())
    )
    return CommandError(f"Duplicate package names not supported:{lines}")


def dependency_cycle_error(names: list[str]) -> CommandError:
    """Return the error that packages depend on each other in a circle."""
    return CommandError(f"packages depend on each other in a circle: {' -> '.join(names)}")


class _BuildCommand(ManyValuesCommand):
    many: ClassVar[frozenset[str]] = frozenset(
        {"--packages-select", "--packages-up-to", "--packages-skip", "--packages-ignore",
         "--base-paths"}
    )  # fmt: skip

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the words, without the options of colcon that have no effect here."""
        own = {text for parameter in self.params for text in parameter.opts}
        known = own | self.many | _FLAGS | _WITH_WORD | _WITH_WORDS
        kept: list[str] = []
        skipped = 0.0  # number of the next words that are values of an option without effect
        for word in args:
            option = word.partition("=")[0]
            if word in known:
                skipped = 0
            if option in _FLAGS | _WITH_WORD | _WITH_WORDS:
                skipped = float("inf") if option in _WITH_WORDS else option in _WITH_WORD
                skipped = 0 if "=" in word else skipped
            elif skipped:
                skipped -= 1
            else:
                kept.append(word)
        return super().parse_args(ctx, kept)


@app.command("build", cls=_BuildCommand)
def build(
    select: Annotated[
        list[str] | None, typer.Option("--packages-select", help="Only these packages")
    ] = None,
    up_to: Annotated[
        list[str] | None, typer.Option("--packages-up-to", help="These and their dependencies")
    ] = None,
    skip: Annotated[
        list[str] | None, typer.Option("--packages-skip", "--packages-ignore", help="Not these")
    ] = None,
    base_paths: Annotated[
        list[Path] | None, typer.Option("--base-paths", help="Folders to search for packages")
    ] = None,
) -> int:
    """Check the packages of the workspace; nothing needs building.

    Other options of colcon build are accepted and have no effect.
    """
    started = time.monotonic()
    folders = _by_name(list(package_folders(base_paths, build_roots())))
    chosen = _chosen(folders, select, up_to, skip)
    known = {*packages(), *folders}.difference(BUNDLED_NAMES)
    failed, noisy = [], []
    for name in chosen:
        problems = _check(name, folders[name], known)
        if any(problem.is_error for problem in problems):
            failed.append(name)
        if problems:
            noisy.append(name)
    _summarize(len(chosen), failed, noisy, time.monotonic() - started)
    if not folders:
        print("\nhint: put the packages of a workspace into its folder src", file=sys.stderr)
    # Lessons build a workspace before it has packages, and then source its script.
    is_workspace = bool(folders) or Path("src").is_dir()
    if is_workspace and _write_scripts(base_paths) and folders and not failed:
        print(f"To use the packages from every folder, type: {source_line()}")
    return Status.ERROR if failed else Status.OK


def _write_scripts(base_paths: list[Path] | None) -> bool:
    """Write the scripts of the workspace to its folder `install`. Return whether that was done."""
    if base_paths:
        return write_setup_scripts(Path("install"), [path.resolve() for path in base_paths])
    roots = build_roots()
    remember(roots)
    return write_setup_scripts(workspace_folder(roots) / "install", [roots[0][0]])


def _by_name(folders: list[Path]) -> dict[str, Path]:
    found: dict[str, list[Path]] = {}
    for folder in folders:
        found.setdefault(package_name(folder), []).append(folder)
    twice = {name: places for name, places in found.items() if len(places) > 1}
    if twice:
        raise duplicate_packages_error(twice)
    return {name: places[0] for name, places in found.items()}


def _chosen(
    folders: dict[str, Path],
    select: list[str] | None,
    up_to: list[str] | None,
    skip: list[str] | None,
) -> list[str]:
    for option, names in {"--packages-select": select, "--packages-up-to": up_to}.items():
        unknown = [name for name in names or () if name not in folders]
        if unknown:
            raise unknown_packages_error(option, unknown, folders)
    needs = {name: _needs(folder, folders) for name, folder in folders.items()}
    ordered = _in_order(needs, up_to or sorted(folders))
    return [name for name in ordered if name in (select or folders) and name not in (skip or ())]


def _needs(folder: Path, folders: Iterable[str]) -> list[str]:
    try:
        named = read_manifest(folder / MANIFEST).named()
    except ManifestError:  # reported when the package is checked
        return []
    return sorted(named.intersection(folders))


def _in_order(needs: dict[str, list[str]], wanted: Iterable[str]) -> list[str]:
    """Return packages in an order in which each package comes after its dependencies."""
    done: list[str] = []

    def add(name: str, path: list[str]) -> None:
        if name in path:
            raise dependency_cycle_error([*path[path.index(name) :], name])
        if name not in done:
            for needed in needs[name]:
                add(needed, [*path, name])
            done.append(name)

    for name in wanted:
        add(name, [])
    return done


def _check(name: str, folder: Path, known: set[str]) -> list[Problem]:
    print(f"Starting >>> {name}")
    started = time.monotonic()
    problems = check_package(folder, known - {name})
    took = f"[{time.monotonic() - started:.2f}s"
    if problems:
        sys.stdout.flush()
        print(f"--- stderr: {name}", *problems, "---", sep="\n", file=sys.stderr)
    if any(problem.is_error for problem in problems):
        print(f"Failed   <<< {name} {took}, exited with code 1]")
    else:
        print(f"Finished <<< {name} {took}]")
    return problems


def _summarize(count: int, failed: list[str], noisy: list[str], took_s: float) -> None:
    print(f"\nSummary: {counted(count - len(failed), 'package')} finished [{took_s:.2f}s]")
    if failed:
        print(f"  {counted(len(failed), 'package')} failed: {' '.join(failed)}")
    if noisy:
        print(f"  {counted(len(noisy), 'package')} had stderr output: {' '.join(noisy)}")
    if count and not failed:
        print("\nNothing needs building: zbot runs packages as they are in their folders.")
