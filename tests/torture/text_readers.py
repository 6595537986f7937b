"""Readers of texts and files: values of users, definitions, launch files, robots and maps."""

from __future__ import annotations

import bz2
import contextlib
import gzip
import io
import lzma
import tarfile
import zipfile
from typing import Any

import zbot  # noqa: F401 - makes the messages importable
from tests.torture.package_readers import MANIFEST
from tests.torture.reader import Reader, file_with, text_of
from zbot.errors import WrongValueError
from zbot.interfaces.collection import DefinitionSourceError, collect
from zbot.interfaces.content_filter import ContentFilter, ContentFilterError
from zbot.interfaces.errors import FieldTypeError, FieldValueError, InterfaceSyntaxError
from zbot.interfaces.field_path import FieldPath, FieldPathError
from zbot.interfaces.message_reader import FieldMisfitError
from zbot.interfaces.parser import parse
from zbot.interfaces.spec import FieldType
from zbot.interfaces.user_definitions import check
from zbot.launch import LaunchContext
from zbot.launch.actions.loop import _values
from zbot.launch.errors import (
    CoercionError,
    EntityTypeError,
    LaunchError,
    LaunchUsageError,
    SubstitutionError,
    SubstitutionSyntaxError,
)
from zbot.launch.frontend import substitution_text, xml_file, yaml_file
from zbot.launch.frontend.parser import Parser
from zbot.launch.parameters import evaluate
from zbot.launch.substitution import TextSubstitution
from zbot.launch.substitutions.nav2_common import _pose
from zbot.launch.typed_value import coerce_to_type
from zbot.libraries.camera_calibration import CameraInfoError, read_calibration
from zbot.libraries.navigation.map_file import MapFileError, read_settings
from zbot.libraries.navigation.map_image import MapImageError, read_image
from zbot.libraries.robot_description.appearance import read_appearance
from zbot.libraries.robot_description.urdf import read_urdf
from zbot.libraries.robot_description.xml_text import DescriptionError
from zbot.parameters.errors import ArgumentsError, ParametersFileError, ParameterValueError
from zbot.parameters.file import parse_value, sections
from zbot.parameters.ros_args import Arguments
from zbot.text.yaml_reader import YamlError, compose_yaml, construct_yaml, read_yaml
from zbot.web.forms.form_value import DURATION, read
from zbot_cli.errors import CommandError
from zbot_cli.input.filter import Filter
from zbot_cli.input.message_values import PopulateError, Template, ValuesError
from zbot_nodes.control.hardware import read_components
from zbot_nodes.frames.frame_tree import FrameTree
from zbot_nodes.images.image_codec import ImageCodecError, decompress
from zbot_nodes.navigation.grids.footprint import footprint_of

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path as PathMessage
from sensor_msgs.msg import CompressedImage, LaserScan

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


def _compose(data: bytes) -> None:
    node = compose_yaml(text_of(data))
    if node is not None:
        construct_yaml(node)


def _form(data: bytes) -> None:
    kind = _KINDS[data[0] % len(_KINDS)] if data else _KINDS[0]
    read(kind, text_of(data[1:]), "a", lambda: 0)


def _definition(data: bytes) -> None:
    kind = ("msg", "srv", "action")[data[0] % 3] if data else "msg"
    parse(f"box_msgs/{kind}/Box", text_of(data[1:]))


def _filter(data: bytes) -> None:
    ContentFilter(text_of(data), ("5", "'a'"), LaserScan).matches(_SCAN)


def _path(data: bytes) -> None:
    path = FieldPath(text_of(data))
    path.check(PathMessage)
    path.select(_SCAN)


def _expression(data: bytes) -> None:
    Filter(text_of(data)).accepts(_SCAN)


def _launch(reader: Any) -> Any:
    def call(data: bytes) -> None:
        Parser().parse_description(reader(text_of(data), "a"))

    return call


def _xml(data: bytes) -> None:
    with contextlib.suppress(LaunchError):
        xml_file.parse(data, "a.xml")
    _launch(xml_file.parse)(data)


def _png() -> bytes:
    from PIL import Image  # noqa: PLC0415 - only for this seed

    file = io.BytesIO()
    Image.new("LA", (3, 2), (100, 255)).save(file, "PNG")
    return file.getvalue()


def _source(data: bytes) -> None:
    for package in collect(file_with("source.zip", data)):
        check(package)


def _sources() -> tuple[bytes, ...]:
    stream, other = io.BytesIO(), io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a-main/package.xml", MANIFEST)
        archive.writestr("a-main/msg/Box.msg", "int32 A=5\nstd_msgs/Header header\n")
        archive.writestr("a-main/srv/Open.srv", "---\nbool success\n")
    with tarfile.open(fileobj=other, mode="w") as tar:
        for name in ("a_msgs/msg/Box.msg", "../b_msgs/msg/Lid.msg", "a" * 200 + "/msg/Long.msg"):
            entry = tarfile.TarInfo(name)
            entry.size, entry.pax_headers = 10, {"comment": "x"}
            tar.addfile(entry, io.BytesIO(b"int32 size"))
    plain = other.getvalue()
    return (stream.getvalue(), plain, *(module.compress(plain) for module in (gzip, bz2, lzma)))


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
_SOURCES = _sources()
_URDF = b"""<robot name="arm"><link name="a"/><link name="b"/><joint name="j" type="revolute">
<parent link="a"/><child link="b"/><origin xyz="1 2 3" rpy="0 0 1"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1e0" effort="1" velocity="1"/><mimic joint="k" multiplier="2"/></joint>
</robot>"""
_APPEARANCE = b"""<robot name="arm"><material name="m"><color rgba="1 0 0 1"/></material>
<link name="a"><visual><origin xyz="1 2 3"/><geometry><box size="1 2 3"/></geometry>
<material name="m"/></visual><collision><geometry><cylinder radius="1" length="2"/></geometry>
</collision></link><link name="b"><visual><geometry><mesh filename="a.stl" scale="1 1 1"/>
</geometry></visual></link></robot>"""
_HARDWARE = b"""<robot name="arm"><link name="a"/><ros2_control name="h" type="system">
<hardware><plugin>x/Y</plugin><param name="b">1</param></hardware><joint name="j">
<command_interface name="position"/><state_interface name="position"><param name="initial_value">1
</param></state_interface></joint></ros2_control></robot>"""
_VALUE_ERRORS = (ValuesError, PopulateError, FieldTypeError, FieldValueError)

TEXT_READERS = (
    Reader(
        "yaml",
        ("zbot.text.yaml_reader",),
        lambda data: read_yaml(text_of(data)),
        (YamlError,),
        _YAML,
    ),
    Reader(
        "yaml_nodes",
        ("zbot.text.yaml_reader", "zbot.interfaces.yaml_text"),
        _compose,
        (YamlError,),
        _YAML,
    ),
    Reader(
        "parameter_value",
        ("zbot.parameters.file", "zbot.parameters.scalar"),
        lambda data: parse_value(text_of(data)),
        (ParameterValueError,),
        (b"1.5", b"[1, 2]", b"'a'", b"0x1f", b"-.inf", b"1e3", *_YAML),
    ),
    Reader(
        "parameter_file",
        ("zbot.parameters.file",),
        lambda data: sections(str(file_with("parameters.yaml", data))),
        (ParametersFileError,),
        (b"/**:\n  ros__parameters:\n    a: 1.5\n    b: {c: [1, 2]}\n", *_YAML),
    ),
    Reader(
        "ros_arguments",
        ("zbot.parameters.ros_args",),
        lambda data: Arguments.parse(["a", "--ros-args", *text_of(data).split("\n")]),
        (ArgumentsError,),
        (b"-r\nchatter:=/b\n-p\na:=[1, 2]\n--log-level\ndebug", b"-r\nn:rostopic://a:=b\n-e\n/a"),
    ),
    Reader(
        "message_values",
        ("zbot_cli.input.message_values", "zbot.interfaces.yaml_message"),
        lambda data: Template(PoseStamped, text_of(data)),
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
        lambda data: Template(LaserScan, text_of(data)),
        _VALUE_ERRORS,
        (b"{ranges: [1, 2.5, .inf], header: {stamp: {sec: 5}}}", b"ranges=[1,2]", *_YAML),
    ),
    Reader(
        "form_entry",
        ("zbot.web.forms.form_value",),
        _form,
        (FieldMisfitError,),
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
        (CommandError,),
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
        lambda data: substitution_text.parse(text_of(data)),
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
        lambda data: coerce_to_type(text_of(data)),
        (CoercionError,),
        (b"1.5", b"[1, 2]", b"yes", *_YAML),
    ),
    Reader(
        "launch_parameter",
        ("zbot.launch.parameters",),
        lambda data: evaluate(LaunchContext(), TextSubstitution(text=text_of(data))),
        (EntityTypeError,),
        (b"1.5", b"[1, 2]", b"1:30", b"[0b1, a]", *_YAML),
    ),
    Reader(
        "launch_loop",
        ("zbot.launch.actions.loop",),
        lambda data: _values(text_of(data)),
        (LaunchUsageError,),
        (b"{name: a, id: 1}", *_YAML),
    ),
    Reader(
        "robot_description",
        ("zbot.libraries.robot_description.xml_text", "zbot.libraries.robot_description.urdf"),
        lambda data: read_urdf(text_of(data)),
        (DescriptionError,),
        (_URDF, b"<a>" * 200, b'<!DOCTYPE a [<!ENTITY b "c">]><robot>&b;</robot>'),
    ),
    Reader(
        "robot_appearance",
        ("zbot.libraries.robot_description.appearance",),
        lambda data: read_appearance(text_of(data)),
        (DescriptionError,),
        (_APPEARANCE, _URDF),
    ),
    Reader(
        "camera_calibration",
        ("zbot.libraries.camera_calibration",),
        lambda data: read_calibration(text_of(data)),
        (CameraInfoError,),
        (
            (
                b"image_width: 2\nimage_height: 1\ncamera_name: left\ndistortion_model: plumb_bob\n"
                b"distortion_coefficients: {data: [0.5]}\ncamera_matrix: {data: "
                b"[1,2,3,4,5,6,7,8,9]}\nrectification_matrix: {data: [1,2,3,4,5,6,7,8,9]}\n"
                b"projection_matrix: {data: [1,2,3,4,5,6,7,8,9,10,11,12]}\n"
            ),
            *_YAML,
        ),
    ),
    Reader(
        "nav2_pose",
        ("zbot.launch.substitutions.nav2_common",),
        lambda data: _pose(text_of(data)),
        (SubstitutionError,),
        (b"{x: 1.0, y: 2, yaw: 0.5}", *_YAML),
    ),
    Reader(
        "outline",
        ("zbot_nodes.navigation.grids.footprint",),
        lambda data: footprint_of(text_of(data), 0.1),
        (ValueError,),
        (b"[[0.1, 0.1], [0.1, -0.1], [-0.1, 0.0]]", b"[]", b"[[1e400, 1], [2, 3], [4, 5]]"),
    ),
    Reader(
        "map_settings",
        ("zbot.libraries.navigation.map_file",),
        lambda data: read_settings(text_of(data)),
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
        ("zbot.libraries.navigation.map_image",),
        lambda data: read_image(file_with("map.png", data)),
        (MapImageError,),
        (b"P5\n# a\n2 2\n255\nabcd", b"P2 2 2 9 1 2 3 4", b"P5 1 1 65535 ab", _png()),
    ),
    Reader(
        "frame_tree",
        ("zbot_nodes.frames.frame_tree",),
        lambda data: FrameTree.of(text_of(data), 0.0).to_svg(),
        (WrongValueError,),
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
        lambda data: read_components(text_of(data)),
        (DescriptionError,),
        (_HARDWARE,),
    ),
)
