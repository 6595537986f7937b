"""Problems of the shape of a tree of frames: loops, parents, several trees, names, topics."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.tf2.diagnosis import advice
from zbot.tf2.diagnosis.problem import Cause, Problem

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.tf2.diagnosis.forest import Forest
    from zbot.tf2.diagnosis.link import Link
    from zbot.tf2.diagnosis.surroundings import Surroundings

_MOST_TREES = 20  #: trees whose missing link is named. A program may make a tree for each object
_MOST_CHANGES = 2  #: poses that a static link may have, e.g. because its program was started again


def of_forest(forest: Forest, surroundings: Surroundings) -> Iterator[Problem]:
    """Yield all problems of the shape."""
    for loop in forest.loops():
        yield of_loop(forest, loop)
    for child in forest.links_of:
        if len(forest.parents(child)) > 1:
            yield of_parents(forest, child)
    yield from _trees(forest, surroundings)
    for child in forest.links_of:
        yield from _publishers(forest.links_of[child], surroundings)
    for link in forest.links:
        yield from _link(link)


def missing_links(forest: Forest) -> list[tuple[str, str]]:
    """Return the parent and the child of each link that would connect two trees.

    Only the links of the first 20 trees are returned, because each needs a search.
    """
    first, *others = forest.separate_roots
    return [forest.missing_link(first, root) for root in others[:_MOST_TREES]]


def of_loop(forest: Forest, loop: list[str]) -> Problem:
    """Return the problem that frames form a loop."""
    down = list(reversed(loop))
    way = " -> ".join([loop[0], *down])
    nodes = sorted(
        {name for child in loop for link in forest.links_of[child] for name in link.nodes}
    )
    action = "publish one of these transforms the other way round, or end its node"
    return Problem(Cause.LOOP, f"{way} is a loop", _and_look(action, nodes), tuple(loop))


def of_parents(forest: Forest, child: str) -> Problem:
    """Return the problem that a frame has several parents."""
    links = {link.parent: link for link in forest.links_of[child]}
    named = " and ".join(f"`{link.parent}` ({advice.who(link)})" for link in links.values())
    text = f"`{child}` has {len(links)} parents, {named}; a frame can have only one"
    nodes = sorted({name for link in links.values() for name in link.nodes})
    action = _and_look("end one of the nodes, or change the child_frame_id of one", nodes)
    return Problem(Cause.TWO_PARENTS, text, action, (child, *links))


def of_trees(forest: Forest, first: str, second: str, note: str = "") -> Problem:
    """Return the problem that two frames are in two trees.

    Args:
        forest: The frames.
        first: A frame of one tree.
        second: A frame of the other tree.
        note: Text at the end of the advice.
    """
    parent, child = forest.missing_link(first, second)
    roots = sorted((forest.root(first), forest.root(second)), key=child.__eq__)
    trees = f"`{roots[0]}` and `{roots[1]}` are two trees"
    similar = forest.similar_names(first, second)
    if similar is not None:
        text = f"{trees}; the names `{similar[0]}` and `{similar[1]}` are almost the same"
        action = f"write '{similar[1]}' in place of '{similar[0]}', or the other way round"
        return Problem(Cause.WRONG_NAME, text, action, similar)
    text = f"{trees}; nobody publishes {parent} -> {child}"
    return Problem(Cause.TWO_TREES, text, advice.connect(parent, child) + note, (parent, child))


def _trees(forest: Forest, surroundings: Surroundings) -> Iterator[Problem]:
    first, *others = forest.separate_roots
    silent = surroundings.silent_nodes(forest.links)
    for root in others[:_MOST_TREES]:
        yield of_trees(forest, first, root, f"; {advice.wake(silent)}" if silent else "")
    more = others[_MOST_TREES:]
    if more:
        text = f"{len(more):,} more trees are not connected with `{first}`"
        yield Problem(Cause.TWO_TREES, text, "connect the other trees first", (first, more[0]))


def _publishers(links: list[Link], surroundings: Surroundings) -> Iterator[Problem]:
    """Yield the problem that several nodes or topics have the transform of one child."""
    latest = links[0]
    same = [link for link in links if link.parent == latest.parent]
    nodes = sorted({name for link in same for name in surroundings.running_nodes(link)})
    if len({link.topic for link in same}) > 1:
        topics = " and ".join(sorted(advice.who(link) for link in same))
        text = f"`{latest.name}` is static and moving: it comes from {topics}"
    elif len(nodes) > 1 and (not latest.is_static or latest.pose_changes):
        poses = " with different poses" if latest.is_static else ""
        text = f"`{latest.name}` comes from {len(nodes)} nodes{poses}: {' and '.join(nodes)}"
    else:
        return
    action = _and_look(
        "end one of the nodes, or turn off its transform (often `publish_tf`)", nodes
    )
    yield Problem(Cause.SEVERAL_PUBLISHERS, text, action, (latest.parent, latest.child))


def _link(link: Link) -> Iterator[Problem]:
    frames = (link.parent, link.child)
    if link.has_slash:
        text = f"`{link.name}` ({advice.who(link)}) is published with a slash before a name"
        action = "remove the slash: tf2 finds no transform for a message with such a frame_id"
        yield Problem(Cause.LEADING_SLASH, text, action, frames, is_warning=True)
    if link.is_static and link.pose_changes > _MOST_CHANGES:
        text = f"`{link.name}` ({advice.who(link)}) is static, but it moves"
        action = "publish it with a TransformBroadcaster, on /tf"
        yield Problem(Cause.MOVING_ON_TF_STATIC, text, action, frames, is_warning=True)


def _and_look(action: str, nodes: list[str]) -> str:
    return f"{action}: {advice.look_at(nodes)}" if nodes else action
