from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot_cli.setup_scripts import SetupFileError, declared_scripts

if TYPE_CHECKING:
    from pathlib import Path

TALKER = {"talker": "pkg.talker:main"}


@pytest.mark.parametrize(
    "source",
    [
        "setup(entry_points={'console_scripts': ['talker = pkg.talker:main']})",
        "setuptools.setup(entry_points={'console_scripts': ('talker=pkg.talker:main',)})",
        "n = 'pkg'\nsetup(entry_points={'console_scripts': [f'talker = {n}.talker:main']})",
        "n = 'pkg'\nsetup(entry_points={'console_scripts': ['talker = ' + n + '.talker:main']})",
        "s = ['talker = pkg.talker:main']\nsetup(entry_points={'console_scripts': s})",
        "e = {'console_scripts': ['talker = pkg.talker:main [extra]']}\nsetup(entry_points=e)",
        "setup(entry_points={'console_scripts': 'talker = pkg.talker:main\\n'})",
        "x = x + ['a']\nsetup(entry_points={'console_scripts': ['talker = pkg.talker:main', x]})",
        "setup(entry_points={'console_scripts': [call(), 'talker = pkg.talker:main']})",
    ],
)
def test_setup_py_is_understood_without_being_run(tmp_path: Path, source: str) -> None:
    (tmp_path / "setup.py").write_text(source)
    assert declared_scripts(tmp_path) == TALKER


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("setup.cfg", "[options.entry_points]\nconsole_scripts =\n    talker = pkg.talker:main\n"),
        (
            "pyproject.toml",
            '[project]\nname = "a"\n[project.scripts]\ntalker = "pkg.talker:main"\n',
        ),
        (
            "pyproject.toml",
            "[ project.scripts ] # run\n'talker' = 'pkg.talker:main' # it\n[x]\na='b'",
        ),
    ],
)
def test_other_files_declare_scripts_too(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text)
    assert declared_scripts(tmp_path) == TALKER


@pytest.mark.parametrize(
    "source", ["", "setup()", "setup(entry_points=make('console_scripts'))", "console_scripts = 1"]
)
def test_a_package_may_declare_nothing(tmp_path: Path, source: str) -> None:
    (tmp_path / "setup.py").write_text(source)
    assert declared_scripts(tmp_path) == {}


def test_a_folder_without_setup_files_declares_nothing(tmp_path: Path) -> None:
    assert declared_scripts(tmp_path) == {}


@pytest.mark.parametrize(
    ("name", "text", "reason"),
    [
        ("setup.py", "setup(entry_points={'console_scripts': [\n", "line 1"),
        ("setup.cfg", "console_scripts = 1\n", "no section headers"),
    ],
)
def test_a_broken_file_is_named(tmp_path: Path, name: str, text: str, reason: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(SetupFileError, match=reason) as caught:
        declared_scripts(tmp_path)
    assert caught.value.path == tmp_path / name


def test_a_file_that_is_no_text_is_named(tmp_path: Path) -> None:
    (tmp_path / "setup.py").write_bytes(b"console_scripts \xff")
    with pytest.raises(SetupFileError, match=r"setup\.py"):
        declared_scripts(tmp_path)
