"""Names of another domain: `/17/temperature` is `/temperature` of student 17.

No name of ROS 2 has a part that begins with a digit, so nothing else can be meant. `/17` alone
stands for the whole domain: `zbot topic list /17`.
"""

from __future__ import annotations

import os
import re

from zbot.errors import ZbotError

NOUNS = frozenset({"action", "graph", "lifecycle", "node", "param", "service", "topic"})

_NAME = re.compile(r"/([0-9]+)(/.*)?", re.ASCII | re.DOTALL)
# What follows the first name here is a value, which may look like anything.
_TAKING_VALUES = frozenset({"call", "pub", "send_goal", "set"})


class SeveralDomainsError(ZbotError):
    """Names of two domains stand in one command."""

    def __init__(self, first: str, second: str) -> None:
        super().__init__(
            f"one command looks at one domain, not at {first} and {second}: use one for each"
        )


def enter_domain(words: list[str]) -> list[str]:
    """Switch this process to the domain that a name names; return the words without it.

    Args:
        words: A noun, its verb, and what follows.

    Raises:
        SeveralDomainsError: Names of two domains stand there.
    """
    only_first = len(words) > 1 and words[1] in _TAKING_VALUES
    domain: str | None = None
    kept: list[str] = []
    for word in words:
        match = None if only_first and domain is not None else _NAME.fullmatch(word)
        if match is None:
            kept.append(word)
            continue
        if domain not in {None, match.group(1)}:
            raise SeveralDomainsError(f"/{domain}", f"/{match.group(1)}")
        domain = match.group(1)
        kept += [match.group(2)] if match.group(2) else []
    if domain is not None:
        os.environ["ZBOT_DOMAIN_ID"] = domain
    return kept
