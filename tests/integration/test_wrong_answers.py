"""Tests of programs in a domain where another program gives wrong answers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from tests.cli.command import zbot as run_zbot
from zbot.graph.snapshot import foreign_topics
from zbot.transport import admin_query
from zbot.transport.admin_query import processes

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zenoh

    from tests.conftest import MakeContext

KEY = "@/dead/router"
ANSWERS = [
    b"",
    b"not JSON",
    b"\xff\xfe",
    b"[" * 20_000,
    b'{"sessions": [{"peer": "**/x", "whatami": "peer"}, 5], "metadata": {"zbot": 7}}',
    b'{"sessions": [{"peer": ["a"], "whatami": []}]}',
    b'{"metadata": {"zbot": {"host": "x", "pid": Infinity, "started": Infinity}}}',
    b'{"metadata": {"zbot": {"host": "\\ud800", "pid": 5, "started": 5}}}',
    b'{"metadata": {"zbot": {"host": "x", "pid": -1, "started": "soon"}}}',
]


@pytest.fixture
def answers(make_context: MakeContext, request: pytest.FixtureRequest) -> Iterator[None]:
    session = make_context().session

    def answer(query: zenoh.Query) -> None:
        with query:
            query.reply(KEY, request.param)

    queryable = session.declare_queryable(KEY, answer)
    yield
    queryable.undeclare()


@pytest.mark.parametrize("answers", ANSWERS, ids=range(len(ANSWERS)), indirect=True)
@pytest.mark.usefixtures("answers")
def test_a_wrong_answer_of_a_router_is_ignored(make_context: MakeContext) -> None:
    context = make_context()
    zbot.Node("present", context=context)
    context.wait_for_peers()
    own = str(context.session.info.zid())
    assert own in admin_query.sessions(context.session, "*", 2.0)
    assert own in processes(context.session)
    assert foreign_topics(context.session, context.graph.snapshot(), 0) == {}


@pytest.mark.parametrize("answers", [b"[" * 20_000], indirect=True)
@pytest.mark.usefixtures("answers")
@pytest.mark.parametrize("command", ["topic list", "node list", "doctor"])
def test_commands_work_beside_a_wrong_answer(command: str) -> None:
    assert not run_zbot(*command.split()).err.startswith("Traceback")
