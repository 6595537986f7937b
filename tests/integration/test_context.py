"""Tests of contexts from `init()` to `shutdown()`."""

from __future__ import annotations

import gc
import weakref
from typing import TYPE_CHECKING

import pytest

import zbot
from zbot.errors import NotInitializedError

if TYPE_CHECKING:
    from tests.conftest import MakeContext


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


def test_the_default_context_that_was_shut_down_can_be_requested(domain: int) -> None:
    zbot.init(domain_id=domain)
    context = zbot.get_default_context()
    zbot.shutdown()
    assert zbot.get_default_context(shutting_down=True) is context
    assert zbot.get_default_context() is not context


def test_undecodable_arguments_are_refused_by_init(domain: int) -> None:
    with pytest.raises(UnicodeEncodeError):
        zbot.init(args=["prog", "Ragnar\udcf6k"], context=zbot.Context(), domain_id=domain)


def test_a_process_may_have_undecodable_arguments(
    make_context: MakeContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.argv", ["prog", "Ragnar\udcf6k"])
    node = zbot.Node("guest", context=make_context())
    assert node.get_node_names() == ["guest"]


def test_a_shut_down_context_is_not_kept_alive(domain: int) -> None:
    context = zbot.Context()
    context.init([], domain_id=domain)
    node = zbot.Node("robot", context=context)
    context.shutdown()
    nodes, contexts = weakref.ref(node), weakref.ref(context)
    del node, context
    gc.collect()
    assert (nodes(), contexts()) == (None, None)
