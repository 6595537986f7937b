"""Tests of the answers for which a page waits, and of the threads in which it does slow work."""

from __future__ import annotations

import asyncio
import threading

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.executor.task import Future
from zbot.remote.service_calls import NoAnswerError
from zbot.web.page.service_call import answer, run_in_thread


def test_functions_that_wait_do_not_delay_others() -> None:
    """A laptop's pool of NiceGUI had some 8 threads."""
    is_over = threading.Event()

    async def run() -> str:
        waits = [asyncio.ensure_future(run_in_thread(is_over.wait)) for _ in range(40)]
        answer = await asyncio.wait_for(run_in_thread("answer".upper), 10.0)
        is_over.set()
        await asyncio.gather(*waits)
        return answer

    try:
        assert asyncio.run(run()) == "ANSWER"
    finally:
        is_over.set()


def test_a_cancelled_call_ends_its_task() -> None:
    """A task that goes on after its cancellation would ask for ever."""
    begun, is_over = threading.Event(), threading.Event()

    def wait() -> None:
        begun.set()
        is_over.wait()

    async def run() -> None:
        task = asyncio.ensure_future(run_in_thread(wait))
        await asyncio.to_thread(begun.wait)
        task.cancel()
        await task

    try:
        with pytest.raises(asyncio.CancelledError):
            asyncio.run(run())
    finally:
        is_over.set()


def test_a_function_may_return_none() -> None:
    results = [asyncio.run(run_in_thread({"a": 1}.get, "b"))]
    assert results == [None]


def test_an_answer_is_returned() -> None:
    future: Future[int] = Future()
    future.set_result(3)
    assert asyncio.run(answer(future, "/add")) == 3


def test_a_missing_answer_is_a_sentence() -> None:
    pending: Future[int] = Future()
    with pytest.raises(NoAnswerError, match=r"/add did not answer within 0\.01 s"):
        asyncio.run(answer(pending, "/add", 0.01))
