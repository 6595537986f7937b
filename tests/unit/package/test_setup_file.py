from __future__ import annotations

import time
from typing import TYPE_CHECKING

import pytest

from zbot.package.errors import SetupFileError
from zbot.package.setup_file import data_files, declared_scripts

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
def test_setup_py_is_parsed_without_running_it(tmp_path: Path, source: str) -> None:
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
        ("pyproject.toml", 'project = {scripts = {talker = "pkg.talker:main"}}'),
        ("pyproject.toml", '[project]\nscripts = {talker = "pkg.talker:main"}'),
        ("pyproject.toml", '[project]\r\nscripts.talker = "pkg.talker:main"\r\n'),
        ("pyproject.toml", 'project.scripts."talker" = "pkg.talker\\u003amain"'),
        ("pyproject.toml", '[project.scripts]\ntalker = """\\\n  pkg.talker:main"""'),
        (
            "pyproject.toml",
            (
                "[project]\ndescription = '''\n[project.scripts]\nlistener = 'pkg.l:main'\n'''\n"
                "[project.scripts]\ntalker = 'pkg.talker:main'"
            ),
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


def test_many_spaces_in_a_line_of_setup_cfg_take_little_time(tmp_path: Path) -> None:
    spaces = "\u2028" * 80_000
    (tmp_path / "setup.cfg").write_text(f"[options.entry_points]\nconsole_scripts{spaces}x\n")
    begin = time.process_time()
    with pytest.raises(SetupFileError, match="parsing errors") as caught:
        declared_scripts(tmp_path)
    assert len(str(caught.value)) < 500
    assert time.process_time() - begin < 2  # 100 s without the limit of spaces


@pytest.mark.parametrize(
    ("name", "text", "reason"),
    [
        ("setup.py", "setup(entry_points={'console_scripts': [\n", "line 1"),
        ("setup.cfg", "console_scripts = 1\n", "no section headers"),
        ("pyproject.toml", "[tool]\n\nx = \n", r"pyproject\.toml: line 3: Invalid value"),
        ("pyproject.toml", "[project]\nx = [1,\n2", r"pyproject\.toml: line 3: "),
        (
            "pyproject.toml",
            "[project]\nx = 1\nx = 2\n",
            r"pyproject\.toml: line 3: Cannot overwrite",
        ),
        ("pyproject.toml", "x = " + "[" * 10_000, "nested"),
        ("pyproject.toml", f"a = {'9' * 5000}", "too many digits"),
        ("pyproject.toml", f"a{'.a' * 30_000} = 1", "a key in it has more than 100 parts"),
        ("pyproject.toml", f"a = {{a{' . a' * 9000} = 1}}", "more than 100 parts"),
        ("pyproject.toml", f"['\"'.a{'.a' * 9000}]", "more than 100 parts"),
        ("setup.cfg", "[x]\n" + "console_scripts\n" * 9000, "it has more than 5000 lines"),
        ("pyproject.toml", "[project]\nscripts = ['a']", "project.scripts must be a table"),
        ("pyproject.toml", "[project.scripts]\na = 1", "project.scripts must be a table"),
    ],
)
def test_a_broken_file_is_named(tmp_path: Path, name: str, text: str, reason: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(SetupFileError, match=reason) as caught:
        declared_scripts(tmp_path)
    assert caught.value.path == tmp_path / name


def test_long_texts_in_a_pyproject_are_no_long_keys(tmp_path: Path) -> None:
    text = f"a = '{'a.' * 200}'\nb = {[1.5] * 200}\n[project.scripts]\ntalker = 'pkg.talker:main'"
    (tmp_path / "pyproject.toml").write_text(text)
    assert declared_scripts(tmp_path) == TALKER


def test_an_undecodable_file_is_named(tmp_path: Path) -> None:
    (tmp_path / "setup.py").write_bytes(b"console_scripts \xff")
    with pytest.raises(SetupFileError, match=r"setup\.py"):
        declared_scripts(tmp_path)
    (tmp_path / "setup.py").unlink()
    (tmp_path / "pyproject.toml").write_bytes(b"\nx = '\xff'")
    with pytest.raises(SetupFileError, match=r"pyproject\.toml: line 2: "):
        declared_scripts(tmp_path)


# -- data files ----------------------------------------------------------------------------------

BOTH = [("share/pkg/launch", "launch/a.launch.py"), ("share/pkg/launch", "launch/b.launch.py")]


@pytest.mark.parametrize(
    "source",
    [
        "setup(data_files=[('share/pkg/launch', ['launch/a.launch.py', 'launch/b.launch.py'])])",
        "setup(data_files=[('share/pkg/launch', glob('launch/*.launch.py'))])",
        "setup(data_files=[('share/pkg/launch', sorted(glob.glob('launch/*')))])",
        "setup(data_files=[('share/pkg/launch', glob(os.path.join('launch', '*.[pxy][yma]*')))])",
        "setup(data_files=[('share/pkg/launch', [f for f in glob('l*/*', recursive=True)])])",
        "p = 'pkg'\nsetup(data_files=[('share/' + p + '/launch', glob('launch/*.py'))])",
        "p = 'pkg'\nsetup(data_files=[(f'share/{p}/launch', glob('launch/*.py'))])",
        "p = 'pkg'\nsetup(data_files=[('share/%s/launch' % p, glob('launch/*'))])",
        "p = 'pkg'\nsetup(data_files=[('share/{}/launch'.format(p), glob('launch/*'))])",
        "p = 'pkg'\nsetup(data_files=[(join('share', p, 'launch'), glob('launch/*'))])",
        "l = [('share/pkg/launch', glob('launch/*'))]\nsetup(data_files=[*l, *unknown])",
        "l = []\nl.append(('share/pkg/launch', glob('launch/*')))\nsetup(data_files=l)",
        "l = []\nl += [('share/pkg/launch', glob('launch/*'))]\nsetup(data_files=l + walk())",
        "setup(data_files=[walked('models'), ('share/pkg/launch', glob('launch/*')), ('x', 1)])",
        "setup(**{'data_files': [('share/pkg/launch', glob('launch/*'))]})",
    ],
)
def test_data_files_are_parsed_without_running_setup_py(tmp_path: Path, source: str) -> None:
    (tmp_path / "launch").mkdir()
    for name in ("b.launch.py", "a.launch.py"):
        (tmp_path / "launch" / name).touch()
    (tmp_path / "setup.py").write_text(source)
    assert list(data_files(tmp_path)) == BOTH


def test_absolute_data_files_are_those_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").touch()
    (tmp_path / "setup.py").write_text(
        "here = os.path.abspath(os.path.dirname(__file__))\n"
        "setup(data_files=[('share/pkg', glob(os.path.join(here, '*.yaml')))])\n"
    )
    assert list(data_files(tmp_path)) == [("share/pkg", str(tmp_path / "a.yaml"))]


@pytest.mark.parametrize(
    "source",
    [
        "setup(data_files='x' % (1, 2))",
        "setup(data_files='{}'.format())",
        "setup(data_files=glob(5))",
        "setup(data_files=[[]] + [('a', ['b'], 'c')])",
        "setup(data_files=[('a', None), (None, ['b']), ('c', 'd'), 5])",
        "setup(data_files={'a': 'b'})",
    ],
)
def test_invalid_data_files_are_left_out(tmp_path: Path, source: str) -> None:
    (tmp_path / "setup.py").write_text(source)
    assert list(data_files(tmp_path)) == []
