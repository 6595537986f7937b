"""Check for packages that the sources import and package.xml does not declare."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.package.workspace import MANIFEST
from zbot_cli.packages.check.checked_package import Problem, imports

if TYPE_CHECKING:
    from collections.abc import Container, Iterator
    from pathlib import Path

    from zbot_cli.packages.check.checked_package import CheckedPackage

#: Packages that launch files import. `ros2 launch` installs these packages, so package.xml need not
#: declare them.
_OF_LAUNCH = ("launch", "launch_ros", "launch_xml", "launch_yaml", "ament_index_python")


def check_dependencies(checked: CheckedPackage, known: Container[str]) -> Iterator[Problem]:
    """Yield a warning for each package that is imported but not declared.

    Args:
        checked: The package to check.
        known: The packages of ROS 2 and of the workspace. Only these packages have to be declared.
    """
    if checked.manifest is None:
        return
    declared = {*checked.manifest.named(), checked.name}
    for path, tree in checked.modules.items():
        own = {path.stem, *(_OF_LAUNCH if _is_launch_file(path, checked.folder) else ())}
        for module, _, line in imports(tree):
            name = module.partition(".")[0]
            if name in known and name not in declared | own:
                declared.add(name)
                text = f"imports {name}: add <depend>{name}</depend> to {MANIFEST}"
                yield Problem(path, line, text, is_error=False)


def _is_launch_file(path: Path, folder: Path) -> bool:
    return "launch" in path.name or "launch" in path.relative_to(folder).parts
