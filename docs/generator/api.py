"""Pages of the public Python names, written from signatures and docstrings."""

from __future__ import annotations

import enum
import importlib
import inspect
import re
import textwrap
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import ModuleType

#: Public packages. Their public names are in `__all__`, or imported in `__init__`.
PACKAGES = (
    "zbot",
    "zbot.action",
    "zbot.lifecycle",
    "zbot.tf2",
    "zbot.bag",
    "zbot.launch",
    "zbot.testing",
    "zbot.qos",
    "zbot.time",
)
_SECTION = re.compile(r"(Args|Returns|Raises|Yields|Attributes):")


def page(package: str) -> str:
    """Return the text of a package's page."""
    module = importlib.import_module(package)
    lines = [f"# {package}\n", f"{_text(module)}\n"]
    for name in public_names(module):
        lines += [f"## {name}\n", *_name(f"{package}.{name}", getattr(module, name))]
    return "\n".join(lines) + "\n"


def public_names(module: ModuleType) -> list[str]:
    """Return the public names of a package, sorted. Modules are not public names."""
    names = getattr(module, "__all__", None) or [
        name for name in dir(module) if not name.startswith("_") and _is_ours(getattr(module, name))
    ]
    return sorted(names, key=str.lower)


def _is_ours(value: object) -> bool:
    home = getattr(value, "__module__", "") or ""
    # Python's own `lazy_names` and `install_importer` are used by the package, not offered.
    internal = {"zbot.lazy_imports", "zbot.interfaces.finder"}
    return home.partition(".")[0] == "zbot" and home not in internal


def _name(path: str, value: Any) -> Iterator[str]:
    if inspect.isclass(value):
        yield from _class(path, value)
    elif callable(value):
        yield f"{_signature(path, value)}\n\n{_text(value)}\n"
    else:
        yield f"`{path} = {value!r}`\n"


def _class(path: str, value: type) -> Iterator[str]:
    if value.__name__ != path.rpartition(".")[2]:
        yield f"The same as `{value.__name__}`.\n"
        return
    bases = [base.__name__ for base in value.__bases__ if base is not object]
    yield f"{_signature(f'class {path}', value)}\n"
    if bases:
        yield f"Bases: {', '.join(f'`{base}`' for base in bases)}\n"
    yield f"{_text(value)}\n"
    if issubclass(value, enum.Enum):
        yield "".join(f"- `{member.name}` = `{member.value!r}`\n" for member in value)
    for name, member in _members(value):
        if isinstance(member, property):
            yield f"### {name}\n\nProperty. {_text(member)}\n"
        else:
            yield f"### {name}()\n\n{_signature(name, member)}\n\n{_text(member)}\n"


def _members(value: type) -> Iterator[tuple[str, Any]]:
    """Return the documented public methods and properties of a class, also inherited ones."""
    for name, member in inspect.getmembers(value):
        home = getattr(member, "fget", member)
        is_ours = str(getattr(home, "__module__", "")).startswith("zbot")
        is_member = inspect.isroutine(member) or isinstance(member, property)
        if is_member and is_ours and not name.startswith("_") and inspect.getdoc(member):
            yield name, member


class _Verbatim:
    """Annotation that is printed without quotes."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __repr__(self) -> str:
        return self.text


def _signature(name: str, value: Any) -> str:
    try:
        signature = inspect.signature(value)
    except (TypeError, ValueError):  # some classes have none, e.g. enumerations
        return f"```text\n{name}\n```"
    parameters = [
        parameter.replace(annotation=_verbatim(parameter.annotation))
        for parameter in signature.parameters.values()
        if parameter.name != "self"
    ]
    returned = inspect.Signature.empty if inspect.isclass(value) else signature.return_annotation
    text = str(signature.replace(parameters=parameters, return_annotation=_verbatim(returned)))
    text = re.sub(r"<(\w[\w.]*)[^>]*>", r"\1", text)  # addresses of objects
    text = re.sub(r"(QoSProfile|Duration)\([^()]+\)", r"\1(...)", text)
    return f"```text\n{_wrapped(name + text)}\n```"


def _verbatim(annotation: Any) -> Any:
    return _Verbatim(annotation) if isinstance(annotation, str) else annotation


def _wrapped(text: str) -> str:
    if len(text) <= 90:
        return text
    head, _, rest = text.partition("(")
    rest = textwrap.fill(rest, 86, break_long_words=False, break_on_hyphens=False)
    return f"{head}(\n{textwrap.indent(rest, '    ')}"


def _text(value: object) -> str:
    """Return a docstring as Markdown: its sections become lists."""
    lines = []
    section = ""
    for line in (inspect.getdoc(value) or "").splitlines():
        found = _SECTION.fullmatch(line)
        if found:
            section = found[1]
            lines.append(f"**{section}**\n")
        elif section and line.startswith("    ") and not line.startswith("     "):
            lines.append(_item(line.strip(), section))
        elif section and line.strip():
            lines.append(f"  {line.strip()}")
        else:
            lines.append(line)
    return "\n".join(lines)


def _item(line: str, section: str) -> str:
    name, colon, rest = line.partition(": ")
    if section in {"Args", "Raises", "Attributes"} and colon:
        return f"- `{name}`: {rest}"
    return f"- {line}" if section in {"Args", "Raises", "Attributes"} else line
