"""Writer of new packages. It prints each step as `ros2 pkg create` does."""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING

from zbot_cli.errors import CommandError
from zbot_cli.packages import templates, vscode

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

_LINTERS = ("copyright", "flake8", "pep257")
_COPYRIGHT_SKIP = """
# Remove this line once every source file has a copyright header.
@pytest.mark.skip(reason='The sources have no copyright headers yet.')"""
_NAME = re.compile(r"[a-zA-Z][a-zA-Z0-9_]*\Z")


def invalid_name_error(what: str, name: str) -> CommandError:
    """Return the error that a package, node or library cannot have a name."""
    good = re.sub(r"\W+", "_", name.removesuffix(".py").lower()).strip("_0123456789")
    return CommandError(
        f"'{name}' cannot be a {what}'s name: use letters, digits and '_'; begin with a letter",
        hint=f"try '{good}'" if good else "",
    )


@dataclass(frozen=True)
class Plan:
    """Plan of a new package: its names, texts and files."""

    name: str
    destination: str
    build_type: str
    package_format: int
    description: str
    license: str
    maintainer: str
    email: str
    dependencies: tuple[str, ...]
    node: str
    library: str
    has_vscode: bool = False  #: whether to write a folder `.vscode`

    def lines(self) -> Iterator[str]:
        """Yield the lines that are printed before files are written."""
        yield "going to create a new package"
        yield f"package name: {self.name}"
        yield f"destination directory: {Path(self.destination).absolute()}"
        yield f"package format: {self.package_format}"
        yield "version: 0.0.0"
        yield f"description: {self.description}"
        yield f"maintainer: {[f'{self.maintainer} <{self.email}>']}"
        yield f"licenses: {[self.license]}"
        yield f"build type: {self.build_type}"
        yield f"dependencies: {list(self.dependencies)}"
        if self.node:
            yield f"node_name: {self.node}"
        if self.library:
            yield f"library_name: {self.library}"


def known_licenses() -> list[str]:
    """Return the SPDX identifiers of the licences whose texts zbot has."""
    folder = files("zbot_cli.packages") / "licenses"
    return sorted(entry.name.removesuffix(".txt") for entry in folder.iterdir())


def create(plan: Plan) -> None:
    """Write a package.

    Raises:
        CommandError: The name of the package, node or library is invalid or is `test`, or the
            folder of the package already exists, or a file cannot be written.
    """
    _check(plan)
    writer = _Writer(plan)
    try:
        writer.write()
    except OSError as exc:
        raise CommandError(f"unable to create folder: {plan.destination}: {exc.strerror}") from exc
    finally:
        # The lines are printed last, so that the package is whole also if nobody reads them.
        print(*plan.lines(), *writer.lines, sep="\n")


def _check(plan: Plan) -> None:
    names = {"package": plan.name, "node": plan.node, "library": plan.library}
    for what, name in names.items():
        if (name or what == "package") and not _NAME.match(name):
            raise invalid_name_error(what, name)
    if plan.build_type == "ament_python" and plan.name == "test":
        raise CommandError(
            "Aborted since 'ament_python' packages can't be named 'test'. "
            "Please choose a different package name."
        )
    folder = Path(plan.destination, plan.name)
    if folder.exists():
        raise CommandError(
            f"\nAborted!\nThe directory already exists: {_shown(plan.destination, plan.name)}\n"
            "Either remove the directory or choose a different destination directory or "
            "package name"
        )


def _shown(folder: str, *names: str) -> str:
    """Return a path as ros2 prints it, with a leading `.`, which `Path` would remove."""
    return "/".join((folder.rstrip("/\\") or "/", *names)).replace("//", "/")


class _Writer:
    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self.lines: list[str] = []  #: what was written

    def write(self) -> None:
        plan = self._plan
        self._folder()
        self._file("package.xml", _manifest(plan))
        if plan.build_type == "ament_python":
            self._write_python()
        else:
            self._write_cpp()
        if plan.has_vscode:
            self._folder(".vscode")
            for name, text in vscode.files(plan.name, plan.node).items():
                self._file(f".vscode/{name}", text)
        if plan.license in known_licenses():
            self._path("LICENSE").write_text(_license(plan), encoding="utf-8")

    def _write_python(self) -> None:
        plan = self._plan
        self.lines.append("creating source folder")
        self._folder(plan.name)
        self._file("setup.py", _setup_py(plan))
        self._file("setup.cfg", templates.SETUP_CFG.substitute(name=plan.name))
        self._folder("resource")
        self._file(f"resource/{plan.name}", "")
        self._file(f"{plan.name}/__init__.py", "")
        self._folder("test")
        for linter in _LINTERS:
            before = _COPYRIGHT_SKIP if linter == "copyright" else ""
            text = templates.LINT_TEST.substitute(linter=linter, before=before)
            self._file(f"test/test_{linter}.py", text)
        if plan.node:
            node = templates.NODE.substitute(name=plan.name)
            self._file(f"{plan.name}/{plan.node}.py", node)
        if plan.library:
            self._folder(f"{plan.name}/{plan.library}")
            self._file(f"{plan.name}/{plan.library}/__init__.py", "")

    def _write_cpp(self) -> None:
        plan = self._plan
        self.lines.append("creating source and include folder")
        self._folder("src")
        self._folder(f"include/{plan.name}")
        self._file("CMakeLists.txt", _cmake_lists(plan))
        if plan.node:
            self._file(f"src/{plan.node}.cpp", templates.CPP_NODE.substitute(name=plan.name))
        if plan.library:
            words = {
                "name": plan.name,
                "target": plan.library,
                "class_name": plan.library.replace("_", " ").title().replace(" ", ""),
                "guard": f"{plan.name}__{plan.library}".upper(),
            }
            header = f"include/{plan.name}/{plan.library}.hpp"
            self._file(header, templates.CPP_HEADER.substitute(words))
            self._file(f"src/{plan.library}.cpp", templates.CPP_LIBRARY.substitute(words))

    def _path(self, *names: str) -> Path:
        return Path(self._plan.destination, self._plan.name, *names)

    def _folder(self, *names: str) -> None:
        shown = _shown(self._plan.destination, self._plan.name, *names)
        self.lines.append(f"creating folder {shown}")
        self._path(*names).mkdir(parents=True)

    def _file(self, name: str, text: str) -> None:
        self.lines.append(f"creating {_shown(self._plan.destination, self._plan.name, name)}")
        self._path(name).write_text(text, encoding="utf-8", newline="\n")


def _manifest(plan: Plan) -> str:
    from xml.sax.saxutils import escape  # noqa: PLC0415 - only for a new package

    build_tools: tuple[str, ...] = ()
    test_tools: tuple[str, ...] = ()
    if plan.build_type == "ament_python":
        test_tools = (*(f"ament_{linter}" for linter in _LINTERS), "python3-pytest")
    elif plan.build_type == "ament_cmake":
        build_tools = ("ament_cmake_ros",) if plan.library else ("ament_cmake",)
        test_tools = ("ament_lint_auto", "ament_lint_common")
    groups = {"buildtool_depend": build_tools, "depend": plan.dependencies}
    words = {
        "format": str(plan.package_format),
        "name": plan.name,
        "build_type": plan.build_type,
        "dependencies": "".join(
            _tags(tag, names) for tag, names in {**groups, "test_depend": test_tools}.items()
        ),
    }
    quoted = {'"': "&quot;"}
    texts = {
        "description": plan.description,
        "email": plan.email,
        "maintainer": plan.maintainer,
        "license": plan.license,
    }
    words.update({key: escape(text, quoted) for key, text in texts.items()})
    return templates.MANIFEST.substitute(words)


def _tags(tag: str, names: Iterable[str]) -> str:
    from xml.sax.saxutils import escape  # noqa: PLC0415 - only for a new package

    lines = "".join(f"  <{tag}>{escape(name)}</{tag}>\n" for name in names)
    return f"\n{lines}" if lines else ""


def _setup_py(plan: Plan) -> str:
    script = f"\n            '{plan.node} = {plan.name}.{plan.node}:main'," if plan.node else ""
    return templates.SETUP_PY.substitute(
        name=plan.name,
        maintainer=repr(plan.maintainer),
        email=repr(plan.email),
        description=repr(plan.description),
        license=repr(plan.license),
        scripts=script,
    )


def _cmake_lists(plan: Plan) -> str:
    is_ament = plan.build_type == "ament_cmake"
    own = ("ament_cmake_ros",) if plan.library else ("ament_cmake",)
    needed = (*(own if is_ament else ()), *plan.dependencies)
    library = templates.CMAKE_LIBRARY.substitute(target=plan.library) if plan.library else ""
    node = templates.CMAKE_NODE.substitute(target=plan.node) if plan.node else ""
    template = templates.CMAKE_LISTS if is_ament else templates.PLAIN_CMAKE_LISTS
    packages = "\n".join(f"find_package({name} REQUIRED)" for name in needed)
    return template.substitute(name=plan.name, packages=packages, targets=library + node)


def _license(plan: Plan) -> str:
    from datetime import datetime, timezone  # noqa: PLC0415 - only for a licence file

    text = (files("zbot_cli.packages") / "licenses" / f"{plan.license}.txt").read_text(
        encoding="utf-8"
    )
    year = datetime.now(tz=timezone.utc).year
    return Template(text).safe_substitute(year=year, holder=plan.maintainer)


def user_name() -> str:
    """Return the name from git's configuration, or the login name if git has no name."""
    return _git("user.name") or _login_name()


def user_email(name: str) -> str:
    """Return the address from git's configuration, or a placeholder such as `ana@todo.todo`."""
    return _git("user.email") or f"{re.sub(r'[^a-z0-9]+', '.', name.lower()).strip('.')}@todo.todo"


def _login_name() -> str:
    import getpass  # noqa: PLC0415 - needed only without a name in git

    try:
        return getpass.getuser()
    except (ImportError, KeyError, OSError):  # a container's user may not be in /etc/passwd
        return "user"


def _git(key: str) -> str:
    program = shutil.which("git")
    if program is None:
        return ""
    done = subprocess.run(  # noqa: S603 - git itself, with words of ours
        [program, "config", key], capture_output=True, encoding="utf-8", check=False
    )
    return done.stdout.strip()
