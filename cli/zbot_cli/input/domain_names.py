"""Names in other domains: `/17/temperature` is `/temperature` in domain 17 (of student 17).

`/17` alone selects the domain: `zbot topic list /17`. No part of a ROS 2 name begins with a digit,
so these names cannot be confused with ROS 2 names.
"""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

from zbot.errors.suggestion import question, similar_names
from zbot.transport import membership
from zbot.transport.config import COMMAND_DOMAIN
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Iterable

NOUNS = frozenset({"action", "graph", "lifecycle", "node", "param", "service", "topic"})

_DOMAIN_NAME = re.compile(r"/([0-9]+)(/.*)?", re.ASCII | re.DOTALL)
# Verbs that take one name and then values. A value may look like a domain name.
_VERBS_WITH_VALUES = frozenset({"call", "pub", "send_goal", "set"})


def several_domains_error(first: str, second: str) -> CommandError:
    """Return the error that a command line contains names of two domains."""
    return CommandError(
        f"one command works in one domain, not in {first} and {second}: run it once for each"
    )


def select_domain(words: list[str]) -> list[str]:
    """Set this process's domain if a word begins with a domain. Return the words without domains.

    Args:
        words: A noun, its verb, and their arguments.

    Raises:
        CommandError: The words contain names of two domains.
    """
    only_first = len(words) > 1 and words[1] in _VERBS_WITH_VALUES
    domain: str | None = None
    kept: list[str] = []
    for word in words:
        match = None if only_first and domain is not None else _DOMAIN_NAME.fullmatch(word)
        if match is None:
            kept.append(word)
            continue
        if domain not in {None, match.group(1)}:
            raise several_domains_error(f"/{domain}", f"/{match.group(1)}")
        domain = match.group(1)
        kept += [match.group(2)] if match.group(2) else []
    if domain is not None:
        os.environ[COMMAND_DOMAIN] = domain
    return kept


def as_typed(name: str) -> str:
    """Return a name with the domain of the command before it, if the command names a domain."""
    domain = os.environ.get(COMMAND_DOMAIN)
    return f"/{domain}{name}" if domain else name


def did_you_mean(name: str, known: Iterable[str], *, before: str = "") -> str:
    """Return a question with the most similar name of the command's domain, or an empty string."""
    return question(map(as_typed, similar_names(name, known)[:1]), before)


def where_to_look(noun: str) -> str:
    """Return which command lists the topics, services or actions of the command's domain.

    For a student and another domain, return instead who can show the names.
    """
    domain = os.environ.get(COMMAND_DOMAIN)
    if not domain:
        return f"`zbot {noun} list` shows the {noun}s"
    joined = membership.load()
    if joined is not None and joined.role == "student" and str(joined.number) != domain:
        return (
            f"this laptop has number {joined.number}, and sees the names of number {domain} only "
            f"after the teacher typed: zbot share {domain} {joined.number}"
        )
    return f"`zbot {noun} list /{domain}` shows the {noun}s"
