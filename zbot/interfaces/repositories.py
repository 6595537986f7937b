"""List of the repositories that have packages of definitions, from ROS 2's list of packages."""

from __future__ import annotations

from pathlib import Path

_LIST = Path(__file__).with_name("repositories.txt")


def repository_of(package: str) -> str:
    """Return the address of the repository with a package of definitions, or an empty string."""
    start = f"{package} "
    for line in _LIST.read_text(encoding="utf-8").splitlines():
        if line.startswith(start):
            place = line.removeprefix(start)
            return place if "://" in place else f"https://github.com/{place}"
    return ""


def how_to_add(package: str) -> str:
    """Return advice for the user on how to add a missing package of definitions."""
    repository = repository_of(package)
    if repository:
        return f"download {repository} and type `zbot interface add` with its folder"
    return (
        f"type `zbot interface add` with the folder or archive of {package}, or put its .msg files "
        f"into a folder {package}/msg of your workspace or of the current folder, and its .srv "
        f"and .action files into {package}/srv and {package}/action"
    )
