"""Generator of type stubs for message classes. With stubs, an editor completes `Twist().linear.x`.

    python -m zbot.interfaces.stubs FOLDER [PACKAGE ...]

This command writes files such as `FOLDER/std_msgs/msg/__init__.pyi` for the given packages. Without
a package, it writes stubs for the packages in zbot. These stubs are in `zbot/compat/stubs`, in
folders without code, e.g. `std_msgs`. If the folder's name were `std_msgs-stubs`, pyright would
warn at every import that the source is missing. Editors find the folder on `sys.path`, because
`zbot_ros2_names` adds it. Write stubs of your own types into `typings`, which pyright reads by
default, or into a folder in mypy's `mypy_path`.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.interfaces import registry
from zbot.interfaces.array_value import DTYPES
from zbot.interfaces.location import shipped_packages
from zbot.interfaces.spec import ActionSpec, FieldType, MessageSpec, ServiceSpec

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot.interfaces.spec import Field

_HEADER = "# Written by python -m zbot.interfaces.stubs; do not edit."
_IMPORTS = (
    "from array import array",
    "from collections.abc import Collection",
    "from typing import Final, TypeAlias",
    "",
    "import numpy",
    "from numpy.typing import NDArray",
)
_FRAMEWORK = "from zbot.interfaces import Action, Message, Service"
_PYTHON_TYPES = {"bool": "bool", "byte": "bytes", "string": "str", "wstring": "str"}


def write_stubs(folder: Path, packages: Iterable[str]) -> list[Path]:
    """Write the stubs of packages into a folder, and return the written files.

    Raises:
        UnknownPackageError: A package does not exist here. The error suggests similar names.
        InterfaceSyntaxError: A definition is wrong.
    """
    written = []
    for package in packages:
        for name, text in package_stubs(package).items():
            file = folder / package / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8", newline="\n")
            written.append(file)
    return written


def package_stubs(package: str) -> dict[str, str]:
    """Return the stub files of a package as a dictionary from path to text."""
    modules: dict[str, list[str]] = {}
    for name in registry.interface_names(package):
        modules.setdefault(name.split("/")[1], []).append(name)
    imports = [f"from {package} import {kind} as {kind}" for kind in sorted(modules)]
    files = {"__init__.pyi": "\n".join([_HEADER, *imports]) + "\n", "py.typed": ""}
    for kind, names in modules.items():
        files[f"{kind}/__init__.pyi"] = _module(names)
    return files


def _module(names: list[str]) -> str:
    classes = [line for name in names for line in _interface(name)]
    used = sorted({module for name in names for module in _modules_used(name)})
    imports = [f"import {module}" for module in used]
    return "\n".join([_HEADER, *_IMPORTS, "", *imports, _FRAMEWORK, *classes]) + "\n"


def _modules_used(name: str) -> Iterator[str]:
    for message in _messages(name):
        for field in message.fields:
            if field.type.is_message:
                yield _module_of(field.type.base)
    if isinstance(registry.get_spec(name), ActionSpec):
        yield from ("action_msgs.msg", "action_msgs.srv")


def _messages(name: str) -> list[MessageSpec]:
    spec = registry.get_spec(name)
    if isinstance(spec, MessageSpec):
        return [spec]
    if isinstance(spec, ServiceSpec):
        return [spec.request, spec.response, spec.event]
    own = [spec.goal, spec.result, spec.feedback, spec.feedback_message]
    return [*own, *_messages(spec.send_goal.name), *_messages(spec.get_result.name)]


def _interface(name: str) -> Iterator[str]:
    spec = registry.get_spec(name)
    if isinstance(spec, MessageSpec):
        yield from _message(spec)
        return
    for message in _messages(name):
        yield from _message(message)
    if isinstance(spec, ServiceSpec):
        yield from _service(spec)
    else:
        yield from _service(spec.send_goal)
        yield from _service(spec.get_result)
        yield from _action(spec)


def _service(spec: ServiceSpec) -> Iterator[str]:
    short = _short(spec.name)
    yield from ("", f"class {short}(Service):")
    for part in ("Request", "Response", "Event"):
        yield f"    {part}: TypeAlias = {short}_{part}"


def _action(spec: ActionSpec) -> Iterator[str]:
    short = _short(spec.name)
    yield from ("", f"class {short}(Action):")
    for part in ("Goal", "Result", "Feedback"):
        yield f"    {part}: TypeAlias = {short}_{part}"
    yield "    class Impl:"
    yield f"        SendGoalService: TypeAlias = {short}_SendGoal"
    yield f"        GetResultService: TypeAlias = {short}_GetResult"
    yield f"        FeedbackMessage: TypeAlias = {short}_FeedbackMessage"
    yield "        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal"
    yield "        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray"


def _message(spec: MessageSpec) -> Iterator[str]:
    yield from ("", f"class {_short(spec.name)}(Message):")
    yield from _docstring(spec)
    for constant in spec.constants:
        yield f"    {constant.name}: Final = {constant.value!r}"
    accepted = {field.name: _accepted(field.type) for field in spec.fields}
    accepted.setdefault("check_fields", "bool")
    parameters = ", ".join(f"{name}: {kind} = ..." for name, kind in accepted.items())
    yield f"    def __init__(self, *, {parameters}) -> None: ..."
    for field in spec.fields:
        yield from _field(field)


def _docstring(spec: MessageSpec) -> list[str]:
    text = "\n".join([spec.name, "", *spec.text.split("\n")]).rstrip()
    text = text.replace("\\", "\\\\").replace('"""', '\\"\\"\\"')
    lines = [line.rstrip() for line in text.split("\n")]
    indented = "\n".join(f"    {line}" if line else "" for line in lines[1:])
    if not spec.text.strip():
        return [f'    """{lines[0]}"""']
    return [f'    """{lines[0]}', indented, '    """']


def _field(field: Field) -> Iterator[str]:
    stored, accepted = _stored(field.type), _accepted(field.type)
    if stored == accepted:
        yield f"    {field.name}: {stored}"
        return
    yield "    @property"
    yield f"    def {field.name}(self) -> {stored}: ..."
    yield f"    @{field.name}.setter"
    yield f"    def {field.name}(self, value: {accepted}) -> None: ..."


def _stored(kind: FieldType) -> str:
    """Return the type of the field's value."""
    if kind.kind == "scalar":
        return _python_type(kind)
    if not kind.typecode:
        return f"list[{_python_type(kind)}]"
    if kind.kind == "array":
        return f"NDArray[numpy.{DTYPES[kind.typecode]}]"
    return f"array[{_python_type(kind)}]"


def _accepted(kind: FieldType) -> str:
    """Return the type of the values that can be assigned to the field."""
    return _python_type(kind) if kind.kind == "scalar" else f"Collection[{_python_type(kind)}]"


def _python_type(kind: FieldType) -> str:
    if kind.is_message:
        return f"{_module_of(kind.base)}.{_short(kind.base)}"
    return _PYTHON_TYPES.get(kind.base, "float" if kind.base.startswith("float") else "int")


def _module_of(name: str) -> str:
    return ".".join(name.split("/")[:2])


def _short(name: str) -> str:
    return name.rpartition("/")[2]


def main(arguments: list[str]) -> int:
    """Run the command line, and return its exit code."""
    if not arguments or arguments[0].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    folder, *packages = arguments
    for file in write_stubs(Path(folder), packages or shipped_packages()):
        print(file)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
