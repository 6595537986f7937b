"""Readers of the packages of a workspace: setup files, CMake files, manifests and sources."""

from __future__ import annotations

import os

from tests.torture.reader import FOLDER, Reader, file_with
from zbot.package.cmake_file import read_cmake
from zbot.package.errors import SetupFileError
from zbot.package.manifest import ManifestError, read_manifest
from zbot.package.setup_file import data_files, declared_scripts
from zbot.package.workspace import package_name
from zbot_cli.packages.check.checked_package import _parsed
from zbot_cli.packages.executables import workspace_packages


def _setup(data: bytes) -> None:
    folder = file_with("setup.py", data).parent
    assert declared_scripts(folder) is not None
    assert list(data_files(folder)) is not None


def _package(data: bytes) -> None:
    """Read a workspace with this package and a good package, which must stay usable."""
    setup, _, rest = data.partition(b"=====")
    cmake, _, manifest = rest.partition(b"=====")
    source = FOLDER / "workspace"
    for name, content in {
        "setup.py": setup,
        "CMakeLists.txt": cmake,
        "package.xml": manifest,
    }.items():
        (source / "bad").mkdir(parents=True, exist_ok=True)
        (source / "bad" / name).write_bytes(content)
    (source / "good").mkdir(exist_ok=True)
    good = "setup(entry_points={'console_scripts': ['talk = good.talk:main']})"
    (source / "good" / "setup.py").write_text(good)
    before = os.environ.get("ZBOT_WORKSPACE")
    os.environ["ZBOT_WORKSPACE"] = str(source)
    try:
        found = {package.name: package for package in workspace_packages() if package.folder}
        assert all(package.executables is not None for package in found.values())
    finally:
        os.environ.pop("ZBOT_WORKSPACE")
        if before is not None:
            os.environ["ZBOT_WORKSPACE"] = before
    good_one = [package for package in found.values() if package.folder == source / "good"]
    assert [executable.name for executable in good_one[0].executables] == ["talk"]


def _manifest(data: bytes) -> None:
    path = file_with("package.xml", data)
    package_name(path.parent)
    read_manifest(path)


MANIFEST = b"""<?xml version="1.0"?>
<package format="3"><name>robot</name><version>0.0.1</version><description>x</description>
<maintainer email="a@b.c">a</maintainer><license>MIT</license><depend>rclpy</depend>
<export><build_type>ament_python</build_type></export></package>"""
_SETUP = (
    (
        b"from glob import glob\nfrom setuptools import setup\nname = 'robot'\nmore = ['a=b:c']\n"
        b"more += [f'{name} = {name}.main:main']\nmore.append('%s=%s:d' % ('x', name))\n"
        b"setup(name=name, entry_points={'console_scripts': more}, data_files=[('share/' + name, "
        b"glob('launch/*')), ('lib/{}'.format(name), [x.replace('a', 'b') for x in more])])\n"
    ),
    b"x = 'ab'\nx = x + x\nx = [x, x]\nsetup(**{'entry_points': {'console_scripts': x}})\n",
    b"setup(data_files=[(5, 5), [], ('lib/bad', ['\\0'])], console_scripts=5)",
)
_CMAKE = (
    (
        b"project(robot)\nset(A a.py b.py) # x\n#[[ y ]]\nfile(GLOB B launch/*)\n"
        b"install(PROGRAMS ${A} DESTINATION lib/${PROJECT_NAME} RENAME c)\n"
        b'install(DIRECTORY "launch" DESTINATION share)\nadd_executable(x x.cpp)\n'
        b"rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg DEPENDENCIES b)\n"
    ),
    b"set(A ${A}${A})\nset(A ${A} ${${A}})\n",
)

PACKAGE_READERS = (
    Reader(
        "setup_py",
        ("zbot.package.setup_file", "zbot.package.literal", "zbot.package.file_search"),
        _setup,
        (SetupFileError,),
        _SETUP,
        limit_s=3.0,
    ),
    Reader(
        "setup_cfg",
        ("zbot.package.setup_file",),
        lambda data: declared_scripts(file_with("setup.cfg", data).parent),
        (SetupFileError,),
        (b"[options.entry_points]\nconsole_scripts =\n    a = b:c\n", b"[x]\n= console_scripts\n"),
    ),
    Reader(
        "pyproject",
        ("zbot.package.setup_file",),
        lambda data: declared_scripts(file_with("pyproject.toml", data).parent),
        (SetupFileError,),
        (b"[project]\nname = 'a'\n[project.scripts]\na = \"b:c\"\n",),
    ),
    Reader(
        "cmake",
        ("zbot.package.cmake_file",),
        lambda data: read_cmake(file_with("CMakeLists.txt", data).parent),
        (SetupFileError,),
        _CMAKE,
    ),
    Reader(
        "package_xml",
        ("zbot.package.manifest", "zbot.package.workspace", "zbot.package.condition"),
        _manifest,
        (ManifestError,),
        (
            MANIFEST,
            MANIFEST.replace(
                b"<depend>", b"<depend condition=\"($ROS_VERSION == 2 or a != 'b') and c &lt; d\">"
            ),
            MANIFEST.decode().replace('"1.0"', '"1.0" encoding="utf-16"').encode("utf-16"),
            b'<!DOCTYPE a [<!ENTITY b "c">]><package>&b;</package>',
        ),
    ),
    Reader(
        "package",
        ("zbot_cli.packages.executables",),
        _package,
        (),
        tuple(b"=====".join((setup, cmake, MANIFEST)) for setup in _SETUP for cmake in _CMAKE),
        limit_s=3.0,
    ),
    Reader(
        "python_source",
        ("zbot_cli.packages.check.checked_package", "zbot.package.python_source"),
        lambda data: _parsed(file_with("a.py", data)),
        (),
        (
            *_SETUP,
            b"-" * 9000 + b"1",
            b"a" + b".a" * 9000,
            b"import a" + b".a" * 24000,
            b"# coding: punycode\n-" + b"a" * 9000,
        ),
    ),
)
