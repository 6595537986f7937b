"""Tests of the reader of robot descriptions, and of the transforms of joints."""

from __future__ import annotations

import math

import pytest

from zbot.libraries.robot_description.urdf import quaternion, read_urdf
from zbot.libraries.robot_description.xml_text import DescriptionError

LINKS = '<link name="a"/><link name="b"/>'
LIMIT = '<limit lower="-1" upper="2" effort="1" velocity="1"/>'


def joint(inside: str = "", type_: str = "continuous", name: str = "j", ends: str = "a b") -> str:
    parent, child = ends.split()
    both = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{type_}">{both}{inside}</joint>'


def robot(inside: str) -> str:
    return f'<?xml version="1.0" encoding="latin-1"?><robot name="ü">{inside}</robot>'


def test_a_description_is_read() -> None:
    inside = (
        '<origin xyz="1 2 3" rpy="0 0 1.5"/><axis xyz="0 0 2"/><mimic joint="k" multiplier="-2" '
        f'offset="0.5"/>{LIMIT}<safety_controller soft_lower_limit="-0.5" k_velocity="1"/>'
    )
    found = read_urdf(robot(LINKS + joint(inside, "revolute") + "<material name='red'/>"))
    assert (found.name, found.root, found.links) == ("ü", "a", ("a", "b"))
    joint_read = found.joints["j"]
    assert (joint_read.type, joint_read.parent, joint_read.child) == ("revolute", "a", "b")
    assert (joint_read.lower, joint_read.upper, joint_read.soft_lower, joint_read.soft_upper) == (
        -1,
        2,
        -0.5,
        None,
    )
    assert joint_read.axis == (0, 0, 1)
    assert joint_read.origin.translation == (1, 2, 3)
    assert joint_read.mimic is not None
    assert (joint_read.mimic.joint, joint_read.mimic.multiplier, joint_read.mimic.offset) == (
        "k",
        -2,
        0.5,
    )


def test_angles_are_about_fixed_axes() -> None:
    half = math.sqrt(0.5)
    assert quaternion(0, 0, math.pi / 2) == pytest.approx((0, 0, half, half))
    # Roll first: the x axis stays, then yaw turns it to y.
    assert quaternion(math.pi / 2, 0, math.pi / 2) == pytest.approx((0.5, 0.5, 0.5, 0.5))


@pytest.mark.parametrize(
    ("type_", "translation", "rotation"),
    [
        ("continuous", (0, 0, 1), (0, math.sin(0.25), 0, math.cos(0.25))),
        ("revolute", (0, 0, 1), (0, math.sin(0.25), 0, math.cos(0.25))),
        ("prismatic", (0, 0.5, 1), (0, 0, 0, 1)),
        ("fixed", (0, 0, 1), (0, 0, 0, 1)),
        ("floating", (0, 0, 1), (0, 0, 0, 1)),
        ("planar", (0, 0, 1), (0, 0, 0, 1)),
    ],
)
def test_a_position_moves_along_or_about_the_axis(
    type_: str, translation: tuple[float, ...], rotation: tuple[float, ...]
) -> None:
    inside = f'<origin xyz="0 0 1"/><axis xyz="0 3 0"/>{LIMIT}'
    pose = read_urdf(robot(LINKS + joint(inside, type_))).joints["j"].transform(0.5)
    assert pose.translation == pytest.approx(translation)
    assert pose.rotation == pytest.approx(rotation)


@pytest.mark.parametrize("type_", ["continuous", "prismatic"])
def test_a_joint_whose_axis_has_the_length_zero_never_moves(type_: str) -> None:
    inside = f'<origin xyz="0 0 1"/><axis xyz="0 0 0"/>{LIMIT}'
    joint_read = read_urdf(robot(LINKS + joint(inside, type_))).joints["j"]
    assert joint_read.transform(0.5) == joint_read.origin


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "it is empty"),
        ("robot.urdf", "line 1: syntax error"),
        ("<robot name='a'>", "no element found"),
        ("<sdf/>", "the outermost tag is <sdf>, but must be <robot>"),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><robot/>", "must not define entities"),
        ("<!DOCTYPE a [<!ATTLIST a b CDATA 'c'>]><robot/>", "must not declare attributes"),
        ("<a>" * 200, "nested deeper than 100 levels"),
        ("<robot><link name='a'/></robot>", "a <robot> has no name"),
        (robot(""), "it has no <link>"),
        (robot("<link/>"), "a <link> has no name"),
        (robot(LINKS), "'a' and 'b' both have no parent: connect them by a joint"),
        (robot(LINKS + LINKS), "two links have the name 'a'"),
        (robot(LINKS + joint() + joint(ends="b a")), "two joints have the name 'j'"),
        (robot(LINKS + joint() + joint(name="k")), "link 'b' is the child of two joints"),
        (robot(LINKS + joint() + joint(name="k", ends="b a")), "around link 'a' form a loop"),
        (robot(LINKS + joint(ends="a c")), "joint 'j' names the unknown link 'c'"),
        (robot(LINKS + "<joint name='j' type='fixed'/>"), "joint 'j' has no <parent link"),
        (robot(LINKS + joint(type_="hinge")), "joint 'j' has the type 'hinge', not revolute"),
        (robot(LINKS + joint(type_="revolute")), "joint 'j' is revolute, but has no <limit>"),
        (robot(LINKS + joint('<limit effort="1"/>')), "the <limit> of joint 'j' has no velocity"),
        (robot(LINKS + joint('<origin xyz="1 2"/>')), "origin of joint 'j' must be 3 numbers"),
        (robot(LINKS + joint('<origin rpy="0 0 nan"/>')), "must be 3 numbers, not '0 0 nan'"),
        (robot(LINKS + joint("<mimic/>")), "the <mimic> of joint 'j' names no joint"),
        (robot('<xacro:include xmlns:xacro="x"/>'), "it contains <xacro:include>: give the output"),
    ],
)
def test_an_invalid_description_is_refused(text: str, reason: str) -> None:
    with pytest.raises(DescriptionError) as caught:
        read_urdf(text)
    assert reason in str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        *('<robot name=""><link name=""/></robot>', robot('<link name="a"/>').replace("ü", "")),
        *(
            f"{before}{robot(LINKS + joint())}"
            for before in ("\n", " \r\n\t", "<!-- a -->", "\ufeff\n")
        ),
        *(
            f"<!-- a\n --> <!-- b -->\n{robot(LINKS + joint())}",
            f"<!-- a -->{robot(LINKS + joint()).partition('?>')[2]}",
        ),
        robot(LINKS + joint()).replace("<robot", "<!-- a --><!DOCTYPE robot><robot"),
        robot(LINKS + joint()).replace('"1.0"', "'1.1'"),
        robot(LINKS + joint('<axis xyz="0 0 0"/>', "fixed")),
        robot(LINKS + joint('<axis xyz="0 0 0"/>', "floating")),
        robot(LINKS + joint('<axis xyz="0 0 0"/>', "planar")),
        robot(LINKS + joint('<axis xyz="x"/>', "fixed")),
        *(robot(LINKS + joint("<axis/>")), robot(LINKS + joint("<origin/>"))),
        robot(
            LINKS + joint(f'<origin xyz="  1e-3 .5\n +2.\t" rpy="-1E+2 0 5"/>{LIMIT}', "prismatic")
        ),
        robot(LINKS + joint('<mimic joint=""/>')),
        robot(LINKS + joint(name="")),
        robot(
            LINKS + joint() + '<transmission name="t"><joint name="j"/></transmission><gazebo/>'
            '<unknown a="b"/><material name="m"/><sensor/><ros2_control/>'
        ),
        robot(LINKS + joint("<unknown/><dynamics damping='1'/><calibration rising='0'/>")),
        robot(
            '<link name="a"><inertial/><visual name="v"><material name="undefined"/></visual>'
            '<visual/><collision/></link><link name="b"/>' + joint()
        ),
        robot(LINKS + joint()).replace(
            "<robot", '<robot version="1.0" xmlns:xacro="http://www.ros.org/wiki/xacro"'
        ),
    ],
)
def test_what_ros_accepts_is_read(text: str) -> None:
    assert read_urdf(text).links


def test_a_line_in_an_error_counts_the_lines_before_the_declaration() -> None:
    with pytest.raises(DescriptionError, match="line 4: mismatched tag"):
        read_urdf("\n<!-- a -->\n<?xml version='1.0'?>\n<robot name='r'><link></robot>")


def test_many_comments_are_read_fast() -> None:
    assert read_urdf("<!-- a -->" * 5000 + '<robot name="r"><link name="a"/></robot>').links == (
        "a",
    )


@pytest.mark.parametrize("word", ["1_0", "1,5", "inf", "nan", "0x1", "\u0661", "1e", "", "1 2"])
def test_a_word_that_is_not_a_number_is_refused(word: str) -> None:
    with pytest.raises(DescriptionError, match="must be 3 numbers"):
        read_urdf(robot(LINKS + joint(f'<origin xyz="0 0 {word}"/>')))
