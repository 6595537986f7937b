"""Tests of a client's calls: which reply belongs to which call, and their time-outs."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from tests.unit.node.fakes import TIMEOUT, Sender, reply
from zbot.executor.callback_stack import running_callbacks
from zbot.executor.ready_queue import ReadyQueue
from zbot.node.errors import ServiceError
from zbot.node.pending_calls import PendingCalls, ResponseFuture
from zbot.node.service_request import ServiceRequest, response_sample
from zbot.wire.attachment import pack
from zbot.wire.error_reply import pack_error
from zbot.wire.messagepack.codec import messagepack_codec_for

from example_interfaces.srv import AddTwoInts

Response = AddTwoInts.Response


def read(answer: Any) -> Any:
    payload = response_sample(answer, "/add").payload.to_bytes()
    return messagepack_codec_for(Response).decode(payload)


class Calls:
    """Calls of a client, with what they have sent and posted."""

    def __init__(self) -> None:
        self.is_closed = False
        self.posts = 0
        self.ready_queue = ReadyQueue()
        self.calls: PendingCalls[Any] = PendingCalls(
            read, lambda: self.is_closed, self.ready_queue, self._post
        )

    def take(self) -> Any:
        return self.calls.take()

    def _post(self) -> None:
        self.posts += 1

    def send(self, number: int, timeout_s: float | None = None) -> tuple[Any, Sender]:
        request = ServiceRequest(b"", pack(number, 0, bytes(16)), timeout_s=timeout_s)
        sender = Sender()
        response: ResponseFuture[Any] = ResponseFuture(self.calls, request, sender)
        self.calls.add(response)
        response.send()
        return response, sender


@pytest.fixture
def calls() -> Calls:
    return Calls()


def test_each_reply_completes_its_own_call(calls: Calls) -> None:
    sent = [calls.send(number) for number in (1, 2, 3)]
    for number in (2, 0, 1):
        sent[number][1].answer(reply(Response(sum=number)))
    assert [response.result().sum for response, _ in sent] == [0, 1, 2]


def test_only_the_first_of_several_replies_counts(calls: Calls) -> None:
    response, sender = calls.send(1)
    sender.answer(reply(Response(sum=1)), reply(Response(sum=2)))
    assert response.result().sum == 1


def test_a_call_is_found_by_its_number_until_it_is_over(calls: Calls) -> None:
    (first, sender), (second, _) = calls.send(1), calls.send(2)
    assert calls.calls.with_number(1) is first
    assert calls.calls.with_number(2) is second
    sender.answer(reply(Response()))
    with pytest.raises(KeyError, match="no pending request with number 1"):
        calls.calls.with_number(1)


def test_a_forgotten_call_is_never_complete(calls: Calls) -> None:
    response, sender = calls.send(1)
    assert calls.calls.forget(response)
    assert not calls.calls.forget(response)
    sender.answer(reply(Response(sum=1)))
    assert not response.done()
    assert calls.posts == 0


@pytest.mark.parametrize(
    ("replies", "kind", "text"),
    [
        ([], "server_gone", "/add: the server ended before it answered"),
        ([reply(error=pack_error(ValueError("too large")))], "ValueError", "/add: too large"),
        ([reply(error=b"no zbot")], "error", "/add: no zbot"),
    ],
    ids=["no reply", "exception", "text"],
)
def test_a_call_without_a_response_raises_a_service_error(
    calls: Calls, replies: list[Any], kind: str, text: str
) -> None:
    response, sender = calls.send(1)
    sender.answer(*replies)
    error = response.exception()
    assert isinstance(error, ServiceError)
    assert (error.kind, str(error)) == (kind, text)


# -- time-outs -------------------------------------------------------------------------------------


def test_an_attempt_that_times_out_twice_is_repeated_once(calls: Calls) -> None:
    response, sender = calls.send(1)
    sender.answer(TIMEOUT, TIMEOUT)
    assert len(sender.attempts) == 2
    sender.answer(reply(Response(sum=5)))
    assert response.result().sum == 5


def test_the_timeout_doubles_up_to_a_minute(calls: Calls) -> None:
    _, sender = calls.send(1)
    for _ in range(7):
        sender.answer(TIMEOUT)
    assert sender.timeouts_s == [2, 4, 8, 16, 32, 60, 60, 60]


def test_a_call_with_a_timeout_fails_after_it_and_is_not_repeated(calls: Calls) -> None:
    response, sender = calls.send(1, timeout_s=600)
    sender.answer(TIMEOUT)
    assert sender.timeouts_s == [600]
    assert isinstance(response.exception(), ServiceError)


@pytest.mark.parametrize("why", ["forgotten", "closed"])
def test_a_call_that_nobody_waits_for_is_not_repeated(calls: Calls, why: str) -> None:
    response, sender = calls.send(1)
    if why == "closed":
        calls.is_closed = True
    else:
        calls.calls.clear()
    sender.answer(TIMEOUT)
    assert len(sender.attempts) == 1
    assert not response.done()


def test_the_late_end_of_a_former_attempt_is_ignored(calls: Calls) -> None:
    response, sender = calls.send(1)
    sender.answer(TIMEOUT)
    sender.attempts[0][1]()
    assert not response.done()
    assert len(sender.attempts) == 2


# -- callbacks of futures --------------------------------------------------------------------------


def test_the_executor_runs_the_callbacks_of_a_future(calls: Calls) -> None:
    response, sender = calls.send(1)
    seen = list[Any]()
    response.add_done_callback(seen.append)
    sender.answer(reply(Response()))
    assert (seen, calls.posts) == ([], 1)
    taken = calls.take()
    assert taken is response
    taken.run_callbacks(None)
    assert seen == [response]


def test_a_callback_that_is_added_later_is_posted_too(calls: Calls) -> None:
    response, sender = calls.send(1)
    sender.answer(reply(Response()))
    assert calls.take() is response
    response.add_done_callback(print)
    assert calls.take() is response
    assert not calls.calls


def test_a_coroutine_of_a_callback_goes_to_the_executor(calls: Calls) -> None:
    async def later(_: Any) -> None:
        pass

    response, sender = calls.send(1)
    response.add_done_callback(later)
    sender.answer(reply(Response()))
    tasks = list[Any]()
    response.run_callbacks(SimpleNamespace(create_task=tasks.append))
    (coroutine,) = tasks
    coroutine.close()


def test_responses_without_callbacks_do_not_fill_the_queue(calls: Calls) -> None:
    for number in range(100):
        calls.send(number)[1].answer(reply(Response()))
    assert calls.posts == 100
    assert calls.calls
    calls.take()
    assert not calls.calls


def test_each_response_is_reported(calls: Calls) -> None:
    heard = list[int]()
    calls.calls.on_response = heard.append
    for number in (1, 2):
        calls.send(number)[1].answer(reply(Response()))
    assert heard == [1, 1]


def test_a_reply_of_a_server_in_the_same_executor_waits_for_the_end_of_its_callback(
    calls: Calls,
) -> None:
    response, sender = calls.send(1)
    executor: Any = object()
    calls.ready_queue.attach(executor, list[Any]().append)
    running_callbacks.stack.append((executor, None))  # type: ignore[arg-type]
    sender.answer(reply(Response()))
    assert not response.done()
    running_callbacks.pop()
    assert response.done()
