"""Reason why one transform is missing."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from zbot.errors.suggestion import question, similar_names
from zbot.tf2.diagnosis import advice, time_problems, topic_problems, tree_problems
from zbot.tf2.diagnosis.problem import Cause, Problem

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from zbot.tf2.diagnosis.forest import Forest
    from zbot.tf2.diagnosis.link import Link
    from zbot.tf2.diagnosis.surroundings import Surroundings


class MissingTransform:
    """Search for the reason why a transform is missing.

    Args:
        forest: The frames that the program hears.
        others: The frames that only other topics have, by topic.
        surroundings: The time, and who publishes where.
        need: What needs the transform.
    """

    def __init__(
        self,
        forest: Forest,
        others: Mapping[str, Forest],
        surroundings: Surroundings,
        need: time_problems.Need,
    ) -> None:
        self._forest, self._others, self._surroundings = forest, others, surroundings
        self._need = need

    def reason(self, target: str, source: str) -> Problem | None:
        """Return the reason, or None if the transform is known.

        Args:
            target: The frame of the coordinates.
            source: The frame whose position is wanted.
        """
        for frame in (source, target):
            found = self._invalid(frame) or self._unknown(target, source, frame)
            if found is not None:
                return found
        links = self._forest.links_between(target, source)
        if links is None:
            return self._unconnected(target, source)
        found = time_problems.of_way(links, self._need, self._surroundings)
        return found or self._unreliable(links)

    def _unreliable(self, links: Sequence[Link]) -> Problem | None:
        """Return the warning that a frame on the way has several parents, or None."""
        for link in links:
            if len(self._forest.parents(link.child)) > 1:
                return replace(tree_problems.of_parents(self._forest, link.child), is_warning=True)
        return None

    def _invalid(self, frame: str) -> Problem | None:
        if not frame:
            text = f"{self._need.what} has no frame_id"
            return Problem(Cause.UNKNOWN_FRAME, text, "set header.frame_id in its program", ())
        if not frame.startswith("/"):
            return None
        bare = frame.lstrip("/")
        text = f"the name '{frame}' begins with a slash, which tf2 does not accept"
        action = f"write '{bare}' in place of '{frame}' in the program that publishes it"
        return Problem(Cause.LEADING_SLASH, text, action, (frame,))

    def _unknown(self, target: str, source: str, frame: str) -> Problem | None:
        if frame in self._forest.frames:
            return None
        found = self._elsewhere(target, source)
        if found is None and not self._forest.frames:
            found = self._nothing_heard()
        return found or self._misspelt(frame) or self._unpublished(target, source, frame)

    def _elsewhere(self, target: str, source: str) -> Problem | None:
        """Return the problem that the way between the frames is on another topic, or None."""
        for topic, forest in self._others.items():
            if target in forest.frames and source in forest.frames:
                listened = self._surroundings.topic
                text = f"`{target}` and `{source}` are on {topic}, and the program hears {listened}"
                return Problem(Cause.NAMESPACE, text, advice.remap(topic), (target, source))
        return None

    def _nothing_heard(self) -> Problem:
        topics = " and ".join(self._surroundings.topics)
        for topic, forest in self._others.items():
            if forest.links:
                text = f"nothing comes on {topics}, but transforms come on {topic}"
                return Problem(Cause.NAMESPACE, text, advice.remap(topic), ())
        silent = self._surroundings.silent_nodes(())
        if silent:
            text = f"nothing comes on {topics}; the publisher {silent[0]} is silent"
            return Problem(Cause.SILENT_PUBLISHER, text, advice.wake(silent), ())
        return next(topic_problems.of_silence(self._surroundings))

    def _misspelt(self, frame: str) -> Problem | None:
        similar = similar_names(frame, self._forest.frames)
        if not similar:
            return None
        text = f"nobody publishes the frame `{frame}`; {question(similar)}"
        action = f"write '{similar[0]}' in place of '{frame}', or type: "
        action += advice.publish_static(similar[0], frame)
        return Problem(Cause.WRONG_NAME, text, action, (frame, *similar))

    def _unpublished(self, target: str, source: str, frame: str) -> Problem:
        parent, child = self._forest.missing_link(target, source)
        text = f"nobody publishes the frame `{frame}`"
        action = advice.connect(parent, child) + self._silence()
        return Problem(Cause.UNKNOWN_FRAME, text, action, (frame,))

    def _silence(self) -> str:
        silent = self._surroundings.silent_nodes(self._forest.links)
        return f"; {advice.wake(silent)}" if silent else ""

    def _unconnected(self, target: str, source: str) -> Problem:
        loop = self._forest.loop_at(source) or self._forest.loop_at(target)
        if loop:
            return tree_problems.of_loop(self._forest, loop)
        for child in self._forest.links_of:
            if self._forest.joins(child, target, source):
                return tree_problems.of_parents(self._forest, child)
        found = self._elsewhere(target, source)
        return found or tree_problems.of_trees(self._forest, target, source, self._silence())
