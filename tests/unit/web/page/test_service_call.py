"""Tests of the answers for which a page waits."""

from __future__ import annotations

import asyncio

import pytest

from zbot.executor.task import Future
from zbot.remote.service_calls import NoAnswerError
from zbot.web.page.service_call import answer


def test_an_answer_is_returned() -> None:
    future: Future[int] = Future()
    future.set_result(3)
    assert asyncio.run(answer(future, "/add")) == 3


def test_a_missing_answer_is_a_sentence() -> None:
    pending: Future[int] = Future()
    with pytest.raises(NoAnswerError, match=r"/add did not answer within 0\.01 s"):
        asyncio.run(answer(pending, "/add", 0.01))
