"""The console scripts that a package declares, read from its files without running any of them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError

if TYPE_CHECKING:
    import ast
    from pathlib import Path

_SECTION = re.compile(r"\s*\[\s*project\s*\.\s*scripts\s*\]\s*(#.*)?\Z")
_ENTRY = re.compile(r"""\s*["']?(?P<name>[\w.-]+)["']?\s*=\s*["'](?P<target>[^"']*)["']""")


class SetupFileError(ZbotError):
    """A package's setup file cannot be read."""

    def __init__(self, path: Path, reason: str) -> None:
        self.path, self.reason = path, reason
        super().__init__(f"cannot read {path}: {reason}")


def declared_scripts(folder: Path) -> dict[str, str]:
    """Return the console scripts of a package: name -> `module:function`.

    Raises:
        SetupFileError: A file of it is not what it should be.
    """
    lines = (
        *_setup_py(folder / "setup.py"),
        *_setup_cfg(folder / "setup.cfg"),
        *_pyproject(folder / "pyproject.toml"),
    )
    pairs = (line.partition("=") for line in lines if isinstance(line, str))
    return {name.strip(): _without_extras(target) for name, _, target in pairs if target.strip()}


def _without_extras(target: str) -> str:
    return target.partition("[")[0].strip()


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return ""
    except (OSError, UnicodeDecodeError) as exc:
        raise SetupFileError(path, str(exc)) from exc


def _setup_py(path: Path) -> list[Any]:
    source = _text(path)
    if "console_scripts" not in source:
        return []
    import ast  # noqa: PLC0415 - 8 ms that only a setup.py needs

    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError) as exc:
        line = f"line {exc.lineno}: {exc.msg}" if isinstance(exc, SyntaxError) else str(exc)
        raise SetupFileError(path, line) from None
    names = _assigned(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.keyword) and node.arg == "entry_points":
            groups = _literal(node.value, names)
            scripts = groups.get("console_scripts") if isinstance(groups, dict) else None
            return scripts.splitlines() if isinstance(scripts, str) else list(scripts or ())
    return []


def _assigned(tree: ast.Module) -> dict[str, ast.expr]:
    import ast  # noqa: PLC0415 - as above

    return {
        target.id: statement.value
        for statement in tree.body
        if isinstance(statement, ast.Assign)
        for target in statement.targets
        if isinstance(target, ast.Name)
    }


def _literal(node: ast.AST, names: dict[str, ast.expr]) -> Any:
    """Return what an expression of texts, lists and names stands for; None if it is more."""
    import ast  # noqa: PLC0415 - as above

    match node:
        case ast.Constant(value=value):
            return value
        case ast.Name(id=name) if name in names:
            # Without the name itself: `a = a + "x"` must not go on for ever.
            return _literal(names[name], {key: names[key] for key in names if key != name})
        case ast.List(elts=items) | ast.Tuple(elts=items):
            return [_literal(item, names) for item in items]
        case ast.Dict(keys=keys, values=values):
            pairs = zip(keys, values, strict=True)
            return {_literal(key, names): _literal(value, names) for key, value in pairs if key}
        case ast.JoinedStr(values=parts):
            texts = [_literal(part, names) for part in parts]
            return "".join(texts) if all(isinstance(text, str) for text in texts) else None
        case ast.FormattedValue(value=value):
            return _literal(value, names)
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            first, second = _literal(left, names), _literal(right, names)
            same = type(first) is type(second) and isinstance(first, (str, list))
            return first + second if same else None
    return None


def _setup_cfg(path: Path) -> list[str]:
    source = _text(path)
    if "console_scripts" not in source:
        return []
    import configparser  # noqa: PLC0415 - few packages declare scripts there

    parser = configparser.ConfigParser(interpolation=None)
    try:
        parser.read_string(source)
    except configparser.Error as exc:
        raise SetupFileError(path, exc.message.replace("\n", " ")) from None
    return parser.get("options.entry_points", "console_scripts", fallback="").splitlines()


def _pyproject(path: Path) -> list[str]:
    # Python has a TOML parser from 3.11 on; a table of texts needs none.
    lines, inside = [], False
    for line in _text(path).splitlines():
        if line.lstrip().startswith("["):
            inside = _SECTION.match(line) is not None
        elif inside and (match := _ENTRY.match(line)):
            lines.append(f"{match['name']}={match['target']}")
    return lines
