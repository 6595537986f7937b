"""Tests of packages whose files would fill the memory, never end or break the reader."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import pytest

from tests.conftest import allowed
from zbot.package.cmake_file import read_cmake
from zbot.package.errors import SetupFileError
from zbot.package.file_search import FileSearch, SearchLimitError
from zbot.package.manifest import ManifestError, read_manifest
from zbot.package.setup_file import data_files, declared_scripts
from zbot_cli.packages.executables import workspace_packages

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

END = "\nsetup(entry_points={'console_scripts': x}, data_files=x)\n"
SETUP_FILES = {
    "doubled text": "x = 'ab'\n" + "x = x + x\n" * 60,
    "doubled text in place": "x = 'ab'\n" + "x += x\n" * 60,
    "long text": "x = 'ab'\n" + "x = x + x\n" * 18 + "y = x.strip()\n" * 3000,
    "long path": "x = 'a/'\n" + "x = x + x\n" * 18 + "y = normpath(x)\n" * 3000,
    "long list in place": "x = ['ab']\n" + "x = x + x\n" * 16 + "x += ['a']\n" * 3000,
    "doubled list": "x = ['ab']\n" + "x.extend(x)\n" * 60,
    "doubled tree": "x = ['ab']\n" + "x = [x, x]\n" * 60,
    "doubled tree as text": "x = ['ab']\n" + "x = [x, x]\n" * 60 + "x = str(x)\n",
    "doubled keys": "x = ('ab',)\n" + "x = (x, x)\n" * 60 + "x = {x: x}\n",
    "doubled tree in comprehensions": "x = ['ab']\n" + "x = [x for a in [1, 2]]\n" * 60,
    "comprehensions": f"a = {[0] * 100}\nx = " + "[" * 9 + "a" + " for b in a]" * 9,
    "width": "x = '%1000000000d' % 5",
    "star width": "x = '%*d' % (1000000000, 5)",
    "format width": "x = '{:1000000000}'.format(5)",
    "nested width": "x = '{:{}}'.format(5, 1000000000)",
    "precision": "x = '%.1000000000f' % 1.5",
    "many places": f"x = {'%s' * 9000!r} % ({', '.join(['a'] * 9000)},)".replace(
        "x =", f"a = {'b' * 90_000!r}\nx =", 1
    ),
    "format places": f"x = {'{0}' * 60_000!r}.format({'a' * 10_000!r})",
    "replace": f"x = {'a' * 5000!r}.replace('', {'a' * 5000!r})",
    "join": f"x = {'a' * 90_000!r}.join({list('b' * 900)})",
    "deep": "x = " + "-" * 50_000 + "1",
    "deep list": "x = " + "[" * 90 + "]" * 90 + "+[1]" * 20_000,
    "large": "x = 1 #" + " " * 300_000,
    "long name": "import a" + ".a" * 120_000,
    "long name after continued lines": "import a" + ".\\\na" * 60_000,
}
ODD = [
    "x = 5",
    "x = {[]: 1, {}: 2}",
    "x = [*5]",
    "x = [1]\nx.extend(5)",
    "x = '{0.foo}'.format(5)",
    "x = '%c' % 10000000000",
    "x = sorted([1, 'a'])",
    "x = list(5)",
    "x = ['\\ud800', 'a\\0b', '../' * 3000]",
    "x = [('lib/' + '\\0', ['a\\0b']), ('\\ud800', ['b' * 9000]), (5, 5), ([], [])]",
    "x = glob('a\\0b') + glob('[') + glob('**', recursive=True) + glob('/**', recursive=True)",
    "x = ''.join(5)",
    "x = __file__.replace(5, 5)",
    "x = {1: 2}",
    "x = '\\d'",
]


@pytest.fixture
def quick() -> Iterator[None]:
    begin = time.process_time()
    yield
    assert time.process_time() - begin < allowed(3)


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("name", SETUP_FILES)
def test_a_setup_file_that_is_too_large_is_one_error(tmp_path: Path, name: str) -> None:
    (tmp_path / "setup.py").write_text(f"from setuptools import setup\n{SETUP_FILES[name]}{END}")
    with pytest.raises(SetupFileError, match=r"setup\.py: "):
        declared_scripts(tmp_path)


@pytest.mark.usefixtures("quick")
def test_an_encoding_with_a_slow_decoder_is_one_error(tmp_path: Path) -> None:
    (tmp_path / "setup.py").write_text(f"# coding: punycode\n-{'a' * 200_000}{END}")
    with pytest.raises(SetupFileError, match=r"setup\.py: the encoding punycode"):
        declared_scripts(tmp_path)


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("text", ODD)
def test_odd_values_in_a_setup_file_are_ignored(tmp_path: Path, text: str) -> None:
    (tmp_path / "setup.py").write_text(f"from setuptools import setup\n{text}{END}")
    assert declared_scripts(tmp_path) is not None
    assert list(data_files(tmp_path)) is not None


CMAKE_FILES = {
    "doubled text": "set(A abc)\n" + "set(A ${A}${A})\n" * 60,
    "doubled list": "set(A a b c)\n" + "set(A ${A} ${A})\n" * 60,
    "doubled quoted": "set(A a b c)\n" + 'set(A "${A};${A}")\n' * 60,
    "large": "#" * 300_000,
    "nested loops": "foreach(a b c d)\n" * 15 + "endforeach()\n" * 15,
    "deep loops": "foreach(a b)\n" * 200 + "endforeach()\n" * 200,
    "words in loops": f"foreach(i {'a ' * 9000})\nset(A {'b ' * 9000})\nendforeach()\n",
    "long word in loops": f"foreach(i {'a ' * 9000})\nset(A {'b' * 20_000})\nendforeach()\n",
    "words of variables": f"set(A {'a ' * 9000})\ninstall(FILES {'${A} ' * 900}DESTINATION x)\n",
    "whole disk": "install(DIRECTORY / DESTINATION share)",
}


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("name", CMAKE_FILES)
def test_a_cmake_file_that_is_too_large_is_one_error(
    tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot.package.file_search._MAX_ENTRIES", 500)
    (tmp_path / "CMakeLists.txt").write_text(CMAKE_FILES[name])
    with pytest.raises(SetupFileError, match=r"CMakeLists\.txt: "):
        read_cmake(tmp_path)


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize(
    "text",
    [
        "#[[\n" * 60_000,
        "a(" * 100_000,
        'a("' * 80_000,
        "a(()" * 60_000,
        "set(${" * 40_000,
        "set(A ${A})\nset(B ${A}${B})\n" * 100,
        f"install(FILES {'b' * 9000} \0 DESTINATION x)\ninstall(PROGRAMS \0 DESTINATION x)",
        "file(GLOB A [ ** *)\nfile(GLOB_RECURSE B /a\0)\ninstall(FILES ${A} DESTINATION x)",
        "foreach(a b)\n" * 15_000,
        "function(f)\nf()\nendfunction()\nf()\nf()",
        "macro(f)\ng()\nendmacro()\nmacro(g)\nf()\nendmacro()\nf()",
        "function(f)\nendfunction()\n" * 3000 + "f()\n" * 9000,
        "".join(f"set(a{number} b)\n" for number in range(9000))
        + "function(f)\nendfunction()\n"
        + "f()\n" * 9000,
        'set("" "")\nproject("")\ninstall("")\nadd_executable("")\nrosidl_generate_interfaces("")',
    ],
)
def test_an_odd_cmake_file_is_read_quickly(tmp_path: Path, text: str) -> None:
    (tmp_path / "CMakeLists.txt").write_text(text)
    assert read_cmake(tmp_path) is not None


DEFAULTS = """<!DOCTYPE package [<!ATTLIST a b CDATA "c">]><package><a/></package>"""
DOUBLED = "x = ['setup.py']\n" + "x = x + x\n" * 16
ENTITIES = '<!DOCTYPE package [<!ENTITY a "b">]><package>&a;</package>'


@pytest.mark.parametrize(
    ("source", "reason"),
    [
        (b'<?xml version="1.0" encoding="foo"?><package/>', "its encoding cannot be read"),
        (b'<?xml version="1.0" encoding="utf-32"?><package/>', "its encoding cannot be read"),
        (b'<?xml version="1.0" encoding="rot13"?><package/>', "its encoding cannot be read"),
        (b'<?xml version="1.0" encoding="undefined"?><package/>', "its encoding cannot be read"),
        (ENTITIES.encode(), "must not define entities"),
        (ENTITIES.encode("utf-16"), "must not define entities"),
        (DEFAULTS.encode(), "must not define attributes"),
        (b"<a xmlns:b='" + b"c" * 1001 + b"'/>", "a namespace has more than 1000 characters"),
        (b"<a>" * 60_000, "deeper than 100 levels"),
        (b"<a>" + b" " * 300_000, "must not have more than"),
        (b"", "not valid XML"),
        (b"\xff\xfe<", "not valid XML"),
    ],
)
def test_a_package_xml_that_cannot_be_read_is_one_error(
    tmp_path: Path, source: bytes, reason: str
) -> None:
    (tmp_path / "package.xml").write_bytes(source)
    with pytest.raises(ManifestError, match=r"package\.xml") as caught:
        read_manifest(tmp_path / "package.xml")
    assert reason in caught.value.reason


def test_a_package_xml_may_be_utf_16(tmp_path: Path) -> None:
    tags = {"name": "a", "version": "0.0.1", "description": "é", "maintainer": "m", "license": "l"}
    text = "".join(f"<{tag}>{value}</{tag}>" for tag, value in tags.items())
    (tmp_path / "package.xml").write_bytes(f"<package>{text}</package>".encode("utf-16"))
    assert read_manifest(tmp_path / "package.xml").name == "a"


@pytest.mark.usefixtures("quick")
def test_one_bad_package_does_not_stop_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bad = {
        "setup.py": SETUP_FILES["doubled text"] + END,
        "CMakeLists.txt": "set(A ${A}${A} a)" * 99,
    }
    for name, text in bad.items():
        folder = tmp_path / name.partition(".")[0]
        folder.mkdir()
        (folder / name).write_text(text)
        (folder / "package.xml").write_text(f"<package><name>{folder.name}</name></package>")
    good = tmp_path / "good"
    good.mkdir()
    (good / "setup.py").write_text(
        "setup(entry_points={'console_scripts': ['talk = good.talk:main']})"
    )
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path))
    found = {package.name: package for package in workspace_packages()}
    assert [executable.name for executable in found["good"].executables] == ["talk"]
    assert found["setup"].fault.endswith("setup.py: its expressions are too large to evaluate")
    assert found["CMakeLists"].fault.endswith("CMakeLists.txt: its variables are too large")
    assert found["good"].fault == ""


def test_a_search_does_not_follow_links_in_a_circle(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "one.py").touch()
    (tmp_path / "a" / "back").symlink_to(tmp_path, target_is_directory=True)
    (tmp_path / "a" / "again").symlink_to(tmp_path, target_is_directory=True)
    search = FileSearch(tmp_path)
    assert search.matching("**/*.py", recursive=True) == ["a/one.py"]
    assert search.matching("a/*.py") == ["a/one.py"]
    assert search.matching("*/one.*") == ["a/one.py"]
    assert search.matching("missing/*") == []
    assert search.matching(f"{tmp_path}/a/*.py") == [f"{tmp_path}/a/one.py"]


def test_a_search_ends_after_many_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("zbot.package.file_search._MAX_ENTRIES", 5)
    for number in range(9):
        (tmp_path / str(number)).touch()
    with pytest.raises(SearchLimitError):
        FileSearch(tmp_path).matching("*")


@pytest.mark.usefixtures("quick")
def test_a_pattern_of_many_brackets_matches_nothing(tmp_path: Path) -> None:
    (tmp_path / "a").touch()
    assert FileSearch(tmp_path).matching("[" * 30_000) == []


@pytest.mark.usefixtures("quick")
def test_a_search_opens_a_limited_number_of_folders(tmp_path: Path) -> None:
    with pytest.raises(SearchLimitError):
        FileSearch(tmp_path).matching("**/" * 30_000, recursive=True)
    search = FileSearch(tmp_path)
    with pytest.raises(SearchLimitError):
        [search.matching("*") for _ in range(30_000)]


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("argument", ["scripts=x", "data_files=[('lib/a', x)]"])
def test_a_program_that_is_named_very_often_is_one_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, argument: str
) -> None:
    folder = tmp_path / "a"
    folder.mkdir()
    (folder / "package.xml").write_text("<package><name>a</name></package>")
    (folder / "setup.py").write_text(DOUBLED + f"setup({argument})")
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path))
    (package,) = (found for found in workspace_packages() if found.folder == folder)
    assert [executable.name for executable in package.executables] == ["setup.py"]
