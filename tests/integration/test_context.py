"""Contexts: from `init()` to `shutdown()`."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from zbot.errors import NotInitializedError

if TYPE_CHECKING:
    from collections.abc import Callable

    MakeContext = Callable[[], zbot.Context]


def test_a_given_context_is_shut_down_once(domain: int) -> None:
    context = zbot.Context()
    with pytest.raises(NotInitializedError, match=r"shutdown\(context=\.\.\.\)"):
        zbot.shutdown(context=context)
    zbot.init(context=context, domain_id=domain)
    context.interrupt()
    zbot.shutdown(context=context)
    with pytest.raises(NotInitializedError):
        zbot.shutdown(context=context)
    zbot.try_shutdown(context=context)


def test_the_default_context_may_be_shut_down_twice(domain: int) -> None:
    with zbot.init(domain_id=domain):
        zbot.shutdown()
        zbot.shutdown()
        assert not zbot.ok()


def test_arguments_that_are_no_text_are_refused_where_they_are_given(domain: int) -> None:
    with pytest.raises(UnicodeEncodeError):
        zbot.init(args=["prog", "Ragnar\udcf6k"], context=zbot.Context(), domain_id=domain)


def test_a_process_may_have_arguments_that_are_no_text(
    make_context: MakeContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.argv", ["prog", "Ragnar\udcf6k"])
    node = zbot.Node("guest", context=make_context())
    assert node.get_node_names() == ["guest"]
