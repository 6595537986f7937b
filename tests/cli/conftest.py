"""Fixtures that run commands in the process of the test, and write packages for them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import pytest

from zbot_cli.main import run_command

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    Write = Callable[..., Path]

MANIFEST = """\
<package format="3">
  <name>{name}</name>
  <version>0.0.0</version>
  <description>x</description>
  <maintainer email="a@x.org">a</maintainer>
  <license>MIT</license>
{more}  <export><build_type>{build_type}</build_type></export>
</package>
"""
SETUP = """\
from glob import glob
from setuptools import setup
name = '{name}'
setup(
    name=name,
    packages=[name],
    data_files=[('share/ament_index/resource_index/packages', ['resource/' + name]),
        ('share/' + name, ['package.xml']),
        ('share/' + name + '/launch', glob('launch/*')),
        {data}
    ],
    entry_points={{'console_scripts': [
        {scripts}
    ]}},
)
"""
CONFIG = """\
[develop]
script_dir=$base/lib/{name}
[install]
install_scripts=$base/lib/{name}
"""


@dataclass(frozen=True)
class Result:
    code: int
    out: str
    err: str


class Command(Protocol):
    def __call__(self, *words: str) -> Result: ...


@pytest.fixture
def zbot_command(capsys: pytest.CaptureFixture[str]) -> Command:
    """Return a function that runs `zbot` with the given words."""

    def run(*words: str) -> Result:
        capsys.readouterr()
        try:
            outcome = run_command(list(words))
        except SystemExit as end:
            outcome = int(end.code or 0)
        assert not callable(outcome), "this would become a node"
        captured = capsys.readouterr()
        return Result(outcome, captured.out, captured.err)

    return run


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the `src` folder of a workspace; the workspace is the current folder."""
    source = tmp_path / "workspace" / "src"
    source.mkdir(parents=True)
    monkeypatch.chdir(source.parent)
    return source


@pytest.fixture
def write(workspace: Path) -> Write:
    """Return a function that writes a correct package, except for the given files."""

    def make(
        name: str = "robot",
        *,
        scripts: str = "",
        data: str = "",
        more: str = "",
        build_type: str = "ament_python",
        **files: str,
    ) -> Path:
        folder = workspace / name
        whole = {"package.xml": MANIFEST.format(name=name, more=more, build_type=build_type)}
        if build_type == "ament_python":
            whole["setup.py"] = SETUP.format(name=name, scripts=scripts, data=data)
            whole["setup.cfg"] = CONFIG.format(name=name)
            whole[f"resource/{name}"] = ""
            whole[f"{name}/__init__.py"] = ""
        for path, text in {**whole, **files}.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text)
        return folder

    return make


def write_package(source: Path, name: str, **scripts: str) -> Path:
    """Write a package as `ros2 pkg create --build-type ament_python` does."""
    folder = source / name
    (folder / name).mkdir(parents=True)
    (folder / name / "__init__.py").touch()
    (folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
    entries = [f"{script} = {target}" for script, target in scripts.items()]
    (folder / "setup.py").write_text(
        "from setuptools import setup\n"
        f"setup(name={name!r}, entry_points={{'console_scripts': {entries!r}}})\n"
    )
    return folder
