"""Readers of texts and files: values of users, definitions, launch files, packages."""

from __future__ import annotations

import bz2
import contextlib
import gzip
import io
import lzma
import os
import tarfile
import zipfile
from typing import TYPE_CHECKING, Any

import zbot  # noqa: F401 - makes the messages importable
from tests.torture.reader import Reader, temporary_folder
from zbot.classroom import class_record
from zbot.classroom.address import parse_address
from zbot.classroom.class_record import ClassRecord, RecordError, load_record
from zbot.classroom.errors import AddressError, CodeError
from zbot.classroom.expectation import ExpectationError, parse_expectations
from zbot.classroom.join_code import decode
from zbot.classroom.register import RosterError, read_roster
from zbot.interfaces.added import check
from zbot.interfaces.collection import DefinitionSourceError, collect
from zbot.interfaces.content_filter import ContentFilter, ContentFilterError
from zbot.interfaces.errors import FieldTypeError, FieldValueError, InterfaceSyntaxError
from zbot.interfaces.field_path import FieldPath, FieldPathError
from zbot.interfaces.parser import parse
from zbot.interfaces.spec import FieldType
from zbot.launch.actions.loop import _values
from zbot.launch.errors import CoercionError, LaunchArgumentError, LaunchError
from zbot.launch.frontend import substitution_text, xml_file, yaml_file
from zbot.launch.frontend.errors import SubstitutionSyntaxError
from zbot.launch.frontend.parser import Parser
from zbot.launch.typed_value import coerce_to_type
from zbot.package.cmake_file import read_cmake
from zbot.package.errors import SetupFileError
from zbot.package.manifest import ManifestError, read_manifest
from zbot.package.setup_file import data_files, declared_scripts
from zbot.package.workspace import package_name
from zbot.parameters.errors import ArgumentsError, ParametersFileError, ParameterValueError
from zbot.parameters.file import parse_value, sections
from zbot.parameters.ros_args import Arguments
from zbot.security.certificate import facts
from zbot.security.errors import CertificateError
from zbot.transport import membership
from zbot.transport.membership import Membership, MembershipError
from zbot.web.form_value import DURATION, EntryError, read
from zbot.yaml_reader import YamlError, compose_yaml, construct_yaml, read_yaml
from zbot_cli.input.filter import Filter, FilterError
from zbot_cli.input.message_values import PopulateError, Template, ValuesError
from zbot_cli.packages.check.subject import _parsed
from zbot_cli.packages.executables import workspace_packages
from zbot_nodes.control.hardware import read_components
from zbot_nodes.description.urdf import read_urdf
from zbot_nodes.description.xml_text import DescriptionError
from zbot_nodes.frames.frame_tree import FrameTree, FrameTreeError
from zbot_nodes.images.image_codec import ImageCodecError, decompress
from zbot_nodes.navigation.map_file import MapFileError, read_settings
from zbot_nodes.navigation.map_image import MapImageError, read_image

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path as PathMessage
from sensor_msgs.msg import CompressedImage, LaserScan

if TYPE_CHECKING:
    from pathlib import Path

if TYPE_CHECKING:
    from pathlib import Path

_FOLDER = temporary_folder("zbot-torture-")
_SCAN = LaserScan(ranges=[0.5, 2.0], range_max=9.0)
_SCAN.header.frame_id = "ab" * 500
_KINDS = (
    FieldType("float64", "sequence"),
    FieldType("int8", "sequence", 3),
    FieldType("string", "array", 2),
    FieldType("geometry_msgs/msg/Point", "sequence"),
    FieldType(DURATION),
    FieldType(DURATION, "sequence"),
    FieldType("uint16"),
    FieldType("float32"),
    FieldType("bool"),
    FieldType("string", string_bound=9),
)


def _text(data: bytes) -> str:
    return data.decode(errors="surrogateescape")  # a terminal and a file may have any bytes


def _file(name: str, data: bytes) -> Path:
    path = _FOLDER / name.partition(".")[0] / name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(data)
    return path


def _compose(data: bytes) -> None:
    node = compose_yaml(_text(data))
    if node is not None:
        construct_yaml(node)


def _form(data: bytes) -> None:
    kind = _KINDS[data[0] % len(_KINDS)] if data else _KINDS[0]
    read(kind, _text(data[1:]), "a", lambda: 0)


def _definition(data: bytes) -> None:
    kind = ("msg", "srv", "action")[data[0] % 3] if data else "msg"
    parse(f"box_msgs/{kind}/Box", _text(data[1:]))


def _filter(data: bytes) -> None:
    ContentFilter(_text(data), ("5", "'a'"), LaserScan).matches(_SCAN)


def _path(data: bytes) -> None:
    path = FieldPath(_text(data))
    path.check(PathMessage)
    path.select(_SCAN)


def _expression(data: bytes) -> None:
    Filter(_text(data)).accepts(_SCAN)


def _launch(reader: Any) -> Any:
    def call(data: bytes) -> None:
        Parser().parse_description(reader(_text(data), "a"))

    return call


def _xml(data: bytes) -> None:
    with contextlib.suppress(LaunchError):
        xml_file.parse(data, "a.xml")
    _launch(xml_file.parse)(data)


def _setup(data: bytes) -> None:
    folder = _file("setup.py", data).parent
    assert declared_scripts(folder) is not None
    assert list(data_files(folder)) is not None


def _package(data: bytes) -> None:
    """Read a workspace with this package and a good package, which must stay usable."""
    setup, _, rest = data.partition(b"=====")
    cmake, _, manifest = rest.partition(b"=====")
    source = _FOLDER / "workspace"
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
        found = {one.name: one for one in workspace_packages() if one.folder}
    finally:
        os.environ.pop("ZBOT_WORKSPACE")
        if before is not None:
            os.environ["ZBOT_WORKSPACE"] = before
    good_one = [one for one in found.values() if one.folder == source / "good"]
    assert [one.name for one in good_one[0].executables] == ["talk"]


def _manifest(data: bytes) -> None:
    path = _file("package.xml", data)
    package_name(path.parent)
    read_manifest(path)


def _saved(name: str, load: Any) -> Any:
    def call(data: bytes) -> None:
        before = os.environ.get("XDG_CONFIG_HOME")
        os.environ["XDG_CONFIG_HOME"] = str(_FOLDER)
        try:
            membership.folder().mkdir(exist_ok=True)
            (membership.folder() / name).write_bytes(data)
            load()
        finally:
            os.environ.pop("XDG_CONFIG_HOME")
            if before is not None:
                os.environ["XDG_CONFIG_HOME"] = before

    return call


def _png() -> bytes:
    from PIL import Image  # noqa: PLC0415 - only for this seed

    file = io.BytesIO()
    Image.new("LA", (3, 2), (100, 255)).save(file, "PNG")
    return file.getvalue()


def _record() -> bytes:
    import json  # noqa: PLC0415 - only for this seed
    from dataclasses import asdict  # noqa: PLC0415 - as above

    return json.dumps(asdict(ClassRecord("4b", "ab"))).encode()


def _membership() -> bytes:
    import json  # noqa: PLC0415 - only for this seed
    from dataclasses import asdict  # noqa: PLC0415 - as above

    return json.dumps(asdict(Membership("student", "10.0.0.1", 7447, number=5))).encode()


def _source(data: bytes) -> None:
    for package in collect(_file("source.zip", data)):
        check(package)


def _sources() -> tuple[bytes, ...]:
    stream, other = io.BytesIO(), io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a-main/package.xml", _MANIFEST)
        archive.writestr("a-main/msg/Box.msg", "int32 A=5\nstd_msgs/Header header\n")
        archive.writestr("a-main/srv/Open.srv", "---\nbool success\n")
    with tarfile.open(fileobj=other, mode="w") as tar:
        for name in ("a_msgs/msg/Box.msg", "../b_msgs/msg/Lid.msg", "a" * 200 + "/msg/Long.msg"):
            entry = tarfile.TarInfo(name)
            entry.size, entry.pax_headers = 10, {"comment": "x"}
            tar.addfile(entry, io.BytesIO(b"int32 size"))
    plain = other.getvalue()
    return (stream.getvalue(), plain, *(one.compress(plain) for one in (gzip, bz2, lzma)))


_YAML = (
    b"a: &a [1, 2.5, yes, ~, 2024-01-02, 'b', \"\\u00e9\"]\nb: {<<: {c: 1}, d: *a}\n",
    b"- !!int 5\n- !!binary aGk=\n- |\n  text\n- ? key\n  : value\n",
    b"[" * 9000,
    b"&a [*a]",
)
_LAUNCH_YAML = b"""launch:
- arg: {name: speed, default: "1.5"}
- node:
    pkg: robot
    exec: drive
    param:
    - {name: speed, value: $(var speed)}
- group:
  - push_ros_namespace: {namespace: a}
"""
_LAUNCH_XML = b"""<launch>
  <arg name="speed" default="1.5"/>
  <node pkg="robot" exec="drive" if="$(eval '1 == 1')"><param name="a" value="$(var speed)"/></node>
  <group><set_env name="A" value="b"/></group>
</launch>"""
_MANIFEST = b"""<?xml version="1.0"?>
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
_SOURCES = _sources()
_URDF = b"""<robot name="arm"><link name="a"/><link name="b"/><joint name="j" type="revolute">
<parent link="a"/><child link="b"/><origin xyz="1 2 3" rpy="0 0 1"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1e0" effort="1" velocity="1"/><mimic joint="k" multiplier="2"/></joint>
</robot>"""
_HARDWARE = b"""<robot name="arm"><link name="a"/><ros2_control name="h" type="system">
<hardware><plugin>x/Y</plugin><param name="b">1</param></hardware><joint name="j">
<command_interface name="position"/><state_interface name="position"><param name="initial_value">1
</param></state_interface></joint></ros2_control></robot>"""
_VALUE_ERRORS = (ValuesError, PopulateError, FieldTypeError, FieldValueError)

TEXT_READERS = (
    Reader("yaml", ("zbot.yaml_reader",), lambda data: read_yaml(_text(data)), (YamlError,), _YAML),
    Reader(
        "yaml_nodes",
        ("zbot.yaml_reader", "zbot.interfaces.yaml_text"),
        _compose,
        (YamlError,),
        _YAML,
    ),
    Reader(
        "parameter_value",
        ("zbot.parameters.file",),
        lambda data: parse_value(_text(data)),
        (ParameterValueError,),
        (b"1.5", b"[1, 2]", b"'a'", b"0x1f", b"-.inf", b"1e3", *_YAML),
    ),
    Reader(
        "parameter_file",
        ("zbot.parameters.file",),
        lambda data: sections(str(_file("parameters.yaml", data))),
        (ParametersFileError,),
        (b"/**:\n  ros__parameters:\n    a: 1.5\n    b: {c: [1, 2]}\n", *_YAML),
    ),
    Reader(
        "ros_arguments",
        ("zbot.parameters.ros_args",),
        lambda data: Arguments.parse(["a", "--ros-args", *_text(data).split("\n")]),
        (ArgumentsError,),
        (b"-r\nchatter:=/b\n-p\na:=[1, 2]\n--log-level\ndebug", b"-r\nn:rostopic://a:=b\n-e\n/a"),
    ),
    Reader(
        "message_values",
        ("zbot_cli.input.message_values",),
        lambda data: Template(PoseStamped, _text(data)),
        _VALUE_ERRORS,
        (
            b"{header: auto, pose: {position: {x: 1.5}}}",
            b"pose.position.x=2 header.frame_id=map",
            b"header: {stamp: now}\npose:\n  orientation: {w: 1}",
            *_YAML,
        ),
    ),
    Reader(
        "list_values",
        ("zbot_cli.input.message_values",),
        lambda data: Template(LaserScan, _text(data)),
        _VALUE_ERRORS,
        (b"{ranges: [1, 2.5, .inf], header: {stamp: {sec: 5}}}", b"ranges=[1,2]", *_YAML),
    ),
    Reader(
        "form_entry",
        ("zbot.web.form_value",),
        _form,
        (EntryError,),
        (
            b"\x001, 2.5",
            b"\x01[1, 2, 3]",
            b"\x02[a, 'b']",
            b"\x03[{x: 1}]",
            b"\x04-.inf",
            b"\x041.5",
            b"\x05[1, now]",
            b"\x060x1f",
            b"\x071e999999",
            b"\x08yes",
            b"\x09abc",
        ),
    ),
    Reader(
        "definition",
        ("zbot.interfaces.parser", "zbot.interfaces.literal", "zbot.interfaces.grammar"),
        _definition,
        (InterfaceSyntaxError,),
        (
            b'\x00int32 A=5 # b\nstring<=5 name "a\\"b"\nfloat64[<=3] c [1, 2]\nPoint[2] p\n',
            b"\x01int64 a\n---\nbool b\n",
            b"\x02int32 a\n---\nint32 b\n---\nint32 c\n",
        ),
    ),
    Reader(
        "definition_source",
        ("zbot.interfaces.collection",),
        _source,
        (DefinitionSourceError, InterfaceSyntaxError),
        _SOURCES,
    ),
    Reader(
        "content_filter",
        ("zbot.interfaces.content_filter", "zbot.interfaces.text_pattern"),
        _filter,
        (ContentFilterError,),
        (
            b"range_max > 3 AND NOT (range_min <= %0 OR header.frame_id LIKE 'a%')",
            b"ranges[0] BETWEEN 0 AND 1",
            b"header.frame_id MATCH '(?:[a-z]+|b{2,3}?.)*'",
            b"range_max = 0x1F OR ranges[5] <> -1.5e3",
        ),
    ),
    Reader(
        "field_path",
        ("zbot.interfaces.field_path",),
        _path,
        (FieldPathError,),
        (b"ranges[0]", b"ranges.[-1]", b"header.stamp.sec", b"ranges[0:2:1]"),
    ),
    Reader(
        "python_filter",
        ("zbot_cli.input.filter",),
        _expression,
        (FilterError,),
        (
            b"m.range_max > 0.5 and len(m.ranges) == 2",
            b"m.header.frame_id.startswith('a') or not m.ranges[0]",
            b"-m.range_min * 2 % 3 in m.ranges",
            b"max(m.ranges) if m.ranges else int('5')",
        ),
    ),
    Reader(
        "launch_yaml",
        ("zbot.launch.frontend.yaml_file",),
        _launch(yaml_file.parse),
        (LaunchError,),
        (_LAUNCH_YAML, *_YAML),
    ),
    Reader(
        "launch_xml",
        ("zbot.launch.frontend.xml_file",),
        _xml,
        (LaunchError,),
        (
            _LAUNCH_XML,
            b"<launch>" + b"<group>" * 300,
            b'<?xml version="1.0" encoding="utf-16"?><launch/>',
        ),
    ),
    Reader(
        "launch_substitution",
        ("zbot.launch.frontend.substitution_text",),
        lambda data: substitution_text.parse(_text(data)),
        (SubstitutionSyntaxError, LaunchError),
        (
            b"a $(var b) $(find-pkg-share c)/d",
            b"$(eval '1 + $(var a)')",
            b'\\$(a "b")',
            b"$(" * 900,
        ),
    ),
    Reader(
        "launch_value",
        ("zbot.launch.typed_value",),
        lambda data: coerce_to_type(_text(data)),
        (CoercionError,),
        (b"1.5", b"[1, 2]", b"yes", *_YAML),
    ),
    Reader(
        "launch_loop",
        ("zbot.launch.actions.loop",),
        lambda data: _values(_text(data)),
        (LaunchArgumentError,),
        (b"{name: a, id: 1}", *_YAML),
    ),
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
        lambda data: declared_scripts(_file("setup.cfg", data).parent),
        (SetupFileError,),
        (b"[options.entry_points]\nconsole_scripts =\n    a = b:c\n", b"[x]\n= console_scripts\n"),
    ),
    Reader(
        "pyproject",
        ("zbot.package.pyproject",),
        lambda data: declared_scripts(_file("pyproject.toml", data).parent),
        (SetupFileError,),
        (b"[project]\nname = 'a'\n[project.scripts]\na = \"b:c\"\n",),
    ),
    Reader(
        "cmake",
        ("zbot.package.cmake_file",),
        lambda data: read_cmake(_file("CMakeLists.txt", data).parent),
        (SetupFileError,),
        _CMAKE,
    ),
    Reader(
        "package_xml",
        ("zbot.package.manifest", "zbot.package.workspace", "zbot.package.condition"),
        _manifest,
        (ManifestError,),
        (
            _MANIFEST,
            _MANIFEST.replace(
                b"<depend>", b"<depend condition=\"($ROS_VERSION == 2 or a != 'b') and c &lt; d\">"
            ),
            _MANIFEST.decode().replace('"1.0"', '"1.0" encoding="utf-16"').encode("utf-16"),
            b'<!DOCTYPE a [<!ENTITY b "c">]><package>&b;</package>',
        ),
    ),
    Reader(
        "package",
        ("zbot_cli.packages.executables",),
        _package,
        (),
        tuple(b"=====".join((setup, cmake, _MANIFEST)) for setup in _SETUP for cmake in _CMAKE),
        limit_s=3.0,
    ),
    Reader(
        "python_source",
        ("zbot_cli.packages.check.subject",),
        lambda data: _parsed(_file("a.py", data)),
        (),
        (*_SETUP, b"-" * 9000 + b"1", b"a" + b".a" * 9000),
    ),
    Reader(
        "join_code",
        ("zbot.classroom.join_code",),
        lambda data: decode(_text(data), ["10.0.0.5"]),
        (CodeError,),
        (b"0A1B", b"0A1B-2C3D", b"oil1"),
    ),
    Reader(
        "hub_address",
        ("zbot.classroom.address",),
        lambda data: parse_address(_text(data)),
        (AddressError,),
        (b"192.168.1.10:7447", b"[fe80::1]:7447", b"teacher.local"),
    ),
    Reader(
        "expectation",
        ("zbot.classroom.expectation",),
        lambda data: parse_expectations(_text(data)),
        (ExpectationError,),
        (
            b"publishes std_msgs/String on /a at >= 1.5 Hz and runs /b",
            b"serves example_interfaces/AddTwoInts on add; subscribes std_msgs/msg/String on b",
        ),
    ),
    Reader(
        "roster",
        ("zbot.classroom.register",),
        lambda data: read_roster(_text(data)),
        (RosterError,),
        (b'number,name\n1,Ana\n2,"B"\n', b"5;Eve\n"),
    ),
    Reader(
        "membership_file",
        ("zbot.transport.membership",),
        _saved(membership.FILE, membership.load),
        (MembershipError,),
        (_membership(), b"[]"),
    ),
    Reader(
        "class_file",
        ("zbot.classroom.class_record",),
        _saved(class_record.record_path().name, load_record),
        (RecordError,),
        (_record(), b"{}"),
    ),
    Reader(
        "certificate",
        ("zbot.security.certificate",),
        lambda data: facts(_file("cert.pem", data)),
        (CertificateError,),
        (b"-----BEGIN CERTIFICATE-----\nMIIB\n-----END CERTIFICATE-----\n",),
    ),
    Reader(
        "robot_description",
        ("zbot_nodes.description.xml_text", "zbot_nodes.description.urdf"),
        lambda data: read_urdf(_text(data)),
        (DescriptionError,),
        (_URDF, b"<a>" * 200, b'<!DOCTYPE a [<!ENTITY b "c">]><robot>&b;</robot>'),
    ),
    Reader(
        "map_settings",
        ("zbot_nodes.navigation.map_file",),
        lambda data: read_settings(_text(data)),
        (MapFileError,),
        (
            (
                b"image: a.pgm\nresolution: 0.05\norigin: [1, -2.5, 0]\nnegate: 0\n"
                b"occupied_thresh: 0.65\nfree_thresh: 0.196\nmode: trinary\n"
            ),
            *_YAML,
        ),
    ),
    Reader(
        "map_image",
        ("zbot_nodes.navigation.map_image",),
        lambda data: read_image(_file("map.png", data)),
        (MapImageError,),
        (b"P5\n# a\n2 2\n255\nabcd", b"P2 2 2 9 1 2 3 4", b"P5 1 1 65535 ab", _png()),
    ),
    Reader(
        "frame_tree",
        ("zbot_nodes.frames.frame_tree",),
        lambda data: FrameTree.of(_text(data), 0.0).to_svg(),
        (FrameTreeError,),
        (
            (
                b"a: \n  parent: 'b'\n  broadcaster: 'c'\n  rate: 1.5\n"
                b"  most_recent_transform: 1\n  oldest_transform: 0\n  buffer_length: 1\n"
            ),
            *_YAML,
        ),
    ),
    Reader(
        "compressed_image",
        ("zbot_nodes.images.image_codec",),
        lambda data: decompress(CompressedImage(data=data)),
        (ImageCodecError,),
        (_png(),),
    ),
    Reader(
        "robot_hardware",
        ("zbot_nodes.control.hardware",),
        lambda data: read_components(_text(data)),
        (DescriptionError,),
        (_HARDWARE,),
    ),
)
