"""Tree of an SDF model: its links and joints, as a robot description has them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot.libraries.robot_description.urdf import MOVING, Joint, Robot
from zbot.simulation.robots.equipment import Equipment
from zbot.simulation.robots.model import AXIS_FRAME, RobotModel, check_links, check_size, parts_of
from zbot.simulation.sdf.model import USUAL_INERTIA

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.libraries.robot_description.appearance import Solid
    from zbot.simulation.sdf.model import SdfJoint, SdfModel
    from zbot.tf2.rigid import Rigid

_NEAR_M = 1e-9


def tree_model(model: SdfModel, links: Sequence[str]) -> tuple[RobotModel, Rigid]:
    """Return a part of a model as a robot without equipment, and its root's pose in the model.

    Args:
        model: The model.
        links: The links of the part.

    Raises:
        SimulationError: The part is too large.
    """
    check_links(len(links))
    joints, is_fixed = _joints(model, links)
    children = {joint.child for joint in joints.values()}
    root = next(link for link in links if link not in children)
    tree = Robot(model.name, root, tuple(links) + tuple(_axes(joints, links)), joints)
    solids = {name: model.links[name].shapes.solids for name in links}
    check_size(tree, solids)
    parts = parts_of(tree)
    inertia = {name: own for name in links if (own := model.links[name].inertia) is not None}
    for part in parts:
        if not any(link in inertia for link in part.members):
            inertia[part.link] = USUAL_INERTIA
    friction = {name: mu for name in links if (mu := model.links[name].friction) is not None}
    friction |= {joint.child: 0.0 for joint in model.joints.values() if joint.type == "ball"}
    equipment = Equipment(friction=friction, notices=tuple(model.notices))
    found = RobotModel("", tree, _known(solids), inertia, parts, equipment, is_fixed=is_fixed)
    return found, model.links[root].pose


def _known(solids: dict[str, list[Solid]]) -> dict[str, list[Solid]]:
    return {name: found for name, found in solids.items() if found}


def _joints(model: SdfModel, links: Sequence[str]) -> tuple[dict[str, Joint], bool]:
    """Return the joints of a tree, and whether a joint connects it with the world."""
    known = set(links)
    found: dict[str, Joint] = {}
    above: dict[str, str] = {}  # for each link, the link that moves it
    is_fixed = False
    for joint in model.joints.values():
        if joint.child not in known:
            continue
        if joint.parent == "world":
            is_fixed = True
        elif joint.child in above or _is_above(joint.child, joint.parent, above):
            model.notices.append(f"the joint '{joint.name[:60]}', which closes a loop,")
        else:
            above[joint.child] = joint.parent
            _add(found, joint, model)
    return found, is_fixed


def _is_above(link: str, below: str, above: dict[str, str]) -> bool:
    at: str | None = below
    while at is not None:
        if at == link:
            return True
        at = above.get(at)
    return False


def _add(found: dict[str, Joint], joint: SdfJoint, model: SdfModel) -> None:
    """Add a joint, and a frame where it turns if its link is elsewhere."""
    parent, child = model.links[joint.parent].pose, model.links[joint.child].pose
    type_ = joint.type if joint.type in MOVING else "fixed"
    inside = joint.pose.inverse() @ child  # the link in the joint's frame
    is_same = math.hypot(*inside.translation) < _NEAR_M and abs(inside.rotation[3]) > 1 - 1e-12
    if type_ == "fixed" or is_same:
        origin = parent.inverse() @ child
        found[joint.name] = _joint(joint, type_, joint.child, origin)
        return
    axis = f"{joint.child}{AXIS_FRAME}"
    found[joint.name] = _joint(joint, type_, axis, parent.inverse() @ joint.pose)
    name = f"{joint.name}{AXIS_FRAME}"
    found[name] = Joint(name, "fixed", axis, joint.child, inside)


def _joint(joint: SdfJoint, type_: str, child: str, origin: Rigid) -> Joint:
    return Joint(
        joint.name,
        type_,
        joint.parent,
        child,
        origin,
        joint.axis,
        joint.lower,
        joint.upper,
        effort=joint.effort,
        damping=joint.damping,
        friction=joint.friction,
    )


def _axes(joints: dict[str, Joint], links: Sequence[str]) -> list[str]:
    known = set(links)
    return [joint.child for joint in joints.values() if joint.child not in known]
