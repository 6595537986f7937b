"""Texts of the errors for wrong imports of message types, such as `from std_msgs import String`."""

from __future__ import annotations

from pathlib import Path

from zbot.errors.suggestion import question, similar_names
from zbot.interfaces import registry
from zbot.interfaces.location import has_other_versions, package_folder
from zbot.names import KINDS

_NOUNS = {"msg": "messages", "srv": "services", "action": "actions"}


def text_for_module(package: str, inside: str) -> str:
    """Return what to write in place of the module `package.inside`, which does not exist."""
    first = inside.partition(".")[0]
    modules = [f"{package}.{kind}" for kind in KINDS if _names(package, kind)]
    if first in KINDS:
        return _text_for_kind(package, first, modules)
    right = _import_of(package, first)
    if right:
        return f"{first} is not in {package}, but in {package}.{right[0]}: write {right[1]}"
    near = [kind for kind in KINDS if first in {_NOUNS[kind], _NOUNS[kind][:-1]}]
    near = near or list(similar_names(first, KINDS))
    suggestions = tuple(f"{package}.{kind}" for kind in near if f"{package}.{kind}" in modules)
    has = "" if suggestions else f"; {package} has {' and '.join(modules)}"
    return f"No module named '{package}.{first}'{question(suggestions, '; ')}{has}"


def _text_for_kind(package: str, kind: str, modules: list[str]) -> str:
    beginning = package.partition("_")[0]
    others = [name for name in registry.packages() if name.startswith(f"{beginning}_")]
    near = tuple(f"{name}.{kind}" for name in others if _names(name, kind))
    return (
        f"No module named '{package}.{kind}': {package} has no {_NOUNS[kind]}, only "
        f"{' and '.join(modules)}{question(near, '; ')}"
    )


def text_for_name(package: str, kind: str, name: str) -> str:
    """Return what to write in place of `from package.kind import name`."""
    text = f"cannot import name {name!r} from '{package}.{kind}'"
    near = similar_names(name, _names(package, kind))
    if near:
        return _text_for_file_name(package, kind, near[0]) or text + question(near, "; ")
    if misplaced := _misplaced_file(package, kind, name):
        return f"{text}: move {misplaced} into the folder {package}/{kind}"
    for other in (package, *registry.packages()):
        right = _import_of(other, name)
        if right and (other, right[0]) != (package, kind):
            return f"{text}; {name} is in {other}.{right[0]}: write {right[1]}"
    if has_other_versions(package):
        text += f"; give your robot's version of {package} to `zbot interface add`"
    return text


def text_for_class(package: str, kind: str, name: str) -> str:
    """Return what to write in place of `import package.kind.Name`, or of a wrong file name."""
    wrong_name = _text_for_file_name(package, kind, name)
    return (
        wrong_name
        or f"{name} is a class and not a module: write from {package}.{kind} import {name}"
    )


def _text_for_file_name(package: str, kind: str, name: str) -> str:
    """Return how to rename a file such as `my_speed.msg`, or an empty string if its name is valid.

    Its class can have no underscore, because underscores are in the names of its parts.
    """
    from zbot.interfaces.grammar import GrammarError, check_interface_name  # noqa: PLC0415 - only here

    try:
        check_interface_name(f"{package}/{kind}/{name}")
    except GrammarError as error:
        return f"rename the file {name}.{kind} of {package}: {error}"
    return ""


def _misplaced_file(package: str, kind: str, name: str) -> Path | None:
    """Return a definition in a wrong folder of a package, e.g. `msg/Add.srv` or `msgs/Add.msg`."""
    folder = package_folder(package)
    places = (f"{name}.{kind}", f"*/{name}.{kind}")
    found = (file for place in places for file in (folder.glob(place) if folder else ()))
    return next(found, None)


def _names(package: str, kind: str) -> list[str]:
    return [
        name.rpartition("/")[2]
        for name in registry.interface_names(package)
        if name.split("/")[1] == kind
    ]


def _import_of(package: str, name: str) -> tuple[str, str] | None:
    """Return the kind and the import statement of an interface, if the package has it."""
    for kind in KINDS:
        if name in _names(package, kind):
            return kind, f"from {package}.{kind} import {name}"
    return None


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
