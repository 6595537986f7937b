"""Installed form of source packages: prefixes that contain symbolic links to the sources.

Most packages install each folder under its own name. The share folder of such a package is its
source folder. If setup.py or CMakeLists.txt installs files under other names, the share folder is
in a prefix that zbot makes. The links are updated each time that a caller asks for the prefix, so
no package has to be built.
"""

from __future__ import annotations

import hashlib
import os
import shutil
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.package.bundled_nodes import BUNDLED_PROGRAMS
from zbot.package.cmake_file import Installation, read_cmake
from zbot.package.finder import Origin
from zbot.package.setup_file import data_files, declared_scripts
from zbot.package.user_folders import cache_folder, make_private
from zbot.package.workspace import MANIFEST, SKIPPED
from zbot.package.zbot_command import executable_wrapper

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.package.finder import Package

_PYTHON_TYPE = "ament_python"
_CMAKE_TYPES = {"ament_cmake", "cmake"}


class SymlinkInstallError(ZbotError, OSError):
    """The links to a package's files cannot be written."""

    def __init__(self, package: str, folder: Path, reason: OSError) -> None:
        self.package, self.folder, self.reason = package, folder, reason
        super().__init__(f"cannot link the files of {package} in {folder}: {reason.strerror}")


def share_folder(package: Package) -> Path:
    """Return the share folder of a package.

    Raises:
        SetupFileError: The package's setup.py cannot be read.
        SymlinkInstallError: The links cannot be written.
    """
    if package.origin is Origin.WORKSPACE and moved_files(package):
        return prefix_folder(package) / "share" / package.name
    if package.only or package.launch is not None:
        return prefix_folder(package) / "share" / package.name
    return package.folder


def prefix_folder(package: Package) -> Path:
    """Return the prefix of a package, the folder that has `share/<name>` and `lib/<name>`.

    The prefix of a bundled package has a folder `bin` if ROS 2 has the package's program on the
    PATH.

    Raises:
        SetupFileError: The package's setup.py cannot be read.
        SymlinkInstallError: The links cannot be written.
        WrapperError: The program in `bin` cannot be written.
    """
    if package.prefix is not None:
        return package.prefix
    # The hash contains the folder, because two workspaces may have a package of the same name.
    # The hash contains the name, because zbot's own folder is a package under several names.
    sources = os.fsencode(package.folder.resolve() / package.name)
    place = hashlib.sha256(sources).hexdigest()[:16]
    prefix = cache_folder() / "packages" / place
    files = {f"share/{package.name}/{target}": file for target, file in _shared(package).items()}
    if package.origin is Origin.WORKSPACE:
        programs = _cmake(package.folder).programs
        files.update({target: file for target, file in programs.items() if _is_below(target)})
        files.update(_python_programs(package))
    if package.origin is Origin.BUNDLED:
        files.update({f"bin/{file.name}": file for file in _programs(package.name)})
    try:
        _bring_up_to_date(prefix, files)
    except OSError as exc:
        raise SymlinkInstallError(package.name, prefix, exc) from exc
    return prefix


def _python_programs(package: Package) -> dict[str, Path]:
    """Return what setup.py installs into `lib/<name>`, ROS 2's folder for programs."""
    place = f"lib/{package.name}"
    if _decisive_build_type(package.folder) in _CMAKE_TYPES:
        return {}
    scripts = declared_scripts(package.folder)
    wrappers = [executable_wrapper(package.name, name) for name in scripts if _is_below(name)]
    listed = [
        package.folder / file
        for target, file in data_files(package.folder)
        if PurePosixPath(target) == PurePosixPath(place)
    ]
    return {f"{place}/{file.name}": file for file in (*wrappers, *listed) if os.path.isfile(file)}  # noqa: PTH113 - any name is allowed


def _programs(package: str) -> Iterator[Path]:
    """Yield wrappers for the programs that a bundled package has on the PATH in ROS 2."""
    for name, owner in BUNDLED_PROGRAMS.items():
        if owner == package:
            yield executable_wrapper(package, name)


def moved_files(package: Package) -> dict[str, Path]:
    """Return the files whose installed path differs from their path in the sources.

    The keys are the installed paths.

    Raises:
        SetupFileError: The package's setup.py cannot be read.
    """
    return {
        target: file
        for target, file in installed_files(package).items()
        if os.path.normpath(package.folder / target) != os.path.normpath(file)
    }


def installed_files(package: Package) -> dict[str, Path]:
    """Return the files that a package's build files install below `share/<name>`, by path.

    Raises:
        SetupFileError: The package's setup.py cannot be read.
    """
    listed = [
        (f"{PurePosixPath(folder.replace(os.sep, '/'))}/{Path(file).name}", package.folder / file)
        for folder, file in _data_files(package.folder)
    ]
    listed += _cmake(package.folder).files.items()
    start = f"share/{package.name}/"
    return {
        target.removeprefix(start): file
        for target, file in listed
        if target.startswith(start) and _is_below(target) and file.is_file()
    }


def _data_files(folder: Path) -> Iterator[tuple[str, str]]:
    return iter(()) if _decisive_build_type(folder) in _CMAKE_TYPES else data_files(folder)


def _cmake(folder: Path) -> Installation:
    return Installation() if _decisive_build_type(folder) == _PYTHON_TYPE else read_cmake(folder)


def _decisive_build_type(folder: Path) -> str:
    """Return a package's build type if it has both build files. colcon then uses one of them."""
    if not all((folder / name).is_file() for name in ("setup.py", "CMakeLists.txt")):
        return ""
    from zbot.package.manifest import ManifestError, build_type_in  # noqa: PLC0415 - seldom used

    try:
        return build_type_in(folder / MANIFEST)
    except ManifestError:
        return ""


def _is_below(target: str) -> bool:
    return ".." not in PurePosixPath(target).parts and not target.startswith("/")


def _shared(package: Package) -> dict[str, Path]:
    """Return every file of a package. The keys are paths in the share folder.

    A file that the build files do not install keeps its path. zbot finds such a file, and `zbot
    build` warns that ROS 2 would not find it.
    """
    if package.only:
        # Subfolders of these folders belong to other bundled packages.
        below = (file for part in package.only for file in (package.folder / part).iterdir())
        files = {_relative(file, package): file for file in below if file.is_file()}
    else:
        files = {_relative(file, package): file for file in files_below(package.folder)}
    if package.launch is not None:
        files.update({f"launch/{file.name}": file for file in files_below(package.launch)})
    if package.origin is Origin.WORKSPACE:
        installed = installed_files(package)
        elsewhere = {_relative(file, package) for file in moved_files(package).values()}
        kept = {path: file for path, file in files.items() if path not in elsewhere}
        files = {**kept, **installed}
    return files


def _relative(file: Path, package: Package) -> str:
    return Path(os.path.relpath(file, package.folder)).as_posix()


def files_below(root: Path) -> Iterator[Path]:
    """Yield the files below a folder. Skip other packages and the output of tools."""
    for folder, below, names in os.walk(root):
        below[:] = [name for name in below if _is_part(Path(folder, name))]
        yield from (Path(folder, name) for name in names)


def _is_part(folder: Path) -> bool:
    if folder.name.startswith(".") or folder.name in SKIPPED or folder.suffix == ".egg-info":
        return False
    return not (folder / MANIFEST).is_file()


def _bring_up_to_date(prefix: Path, files: dict[str, Path]) -> None:
    _remove_others(prefix, files)
    for target, file in files.items():
        _link(prefix / target, file.resolve())


def _remove_others(prefix: Path, files: dict[str, Path]) -> None:
    """Remove the links of a prefix that are not in `files`. Never follow a link."""
    for folder, below, names in os.walk(prefix, topdown=False):
        for path in (Path(folder, name) for name in (*names, *below)):
            if path.is_dir() and not path.is_symlink():
                if not any(path.iterdir()):
                    path.rmdir()
            elif path.relative_to(prefix).as_posix() not in files:
                path.unlink(missing_ok=True)


def _link(path: Path, file: Path) -> None:
    if path.exists() and path.samefile(file):
        return
    path.unlink(missing_ok=True)
    make_private(path.parent)
    try:
        path.symlink_to(file)
    except FileExistsError:
        return  # another process has made it
    except OSError:
        _link_without_rights(path, file)


def _link_without_rights(path: Path, file: Path) -> None:
    """Make a hard link, or a copy if the link fails.

    On Windows most users may not make symbolic links, and hard links cannot cross drives.
    """
    try:
        path.hardlink_to(file)
    except OSError:
        shutil.copy2(file, path)
