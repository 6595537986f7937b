"""Tests of the budget of a client."""

from __future__ import annotations

import pytest

from zbot.observer.serving.client_budget import (
    BYTES_PER_S,
    MAX_MESSAGE_BYTES,
    MESSAGES_PER_S,
    REQUESTS_PER_S,
    WORK_SHARE,
    ClientBudget,
    Clients,
    OverBudgetError,
    Rate,
)


class Clock:
    def __init__(self) -> None:
        self.now_s = 100.0

    def __call__(self) -> float:
        return self.now_s


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def budget(clock: Clock) -> ClientBudget:
    return ClientBudget(clock)


def test_a_client_that_stays_below_the_rate_is_never_refused(
    budget: ClientBudget, clock: Clock
) -> None:
    for _ in range(10 * MESSAGES_PER_S):
        budget.check_message(100)
        clock.now_s += 1.001 / MESSAGES_PER_S


def test_the_first_refusal_of_a_second_has_the_sentence(budget: ClientBudget, clock: Clock) -> None:
    for _ in range(2 * MESSAGES_PER_S):
        budget.check_message(1)
    with pytest.raises(OverBudgetError, match="more than 1000 messages a second: 1 of your"):
        budget.check_message(1)
    for _ in range(9):
        with pytest.raises(OverBudgetError, match=r"^$"):
            budget.check_message(1)
    clock.now_s += 1.0
    for _ in range(MESSAGES_PER_S):
        budget.check_message(1)
    with pytest.raises(OverBudgetError, match="a second: 11 of your messages were ignored"):
        budget.check_message(1)


def test_bytes_have_a_rate_too(budget: ClientBudget, clock: Clock) -> None:
    for _ in range(2 * BYTES_PER_S // MAX_MESSAGE_BYTES):
        budget.check_message(MAX_MESSAGE_BYTES)
    with pytest.raises(OverBudgetError, match="bytes a second"):
        budget.check_message(MAX_MESSAGE_BYTES)
    clock.now_s += 1.0
    budget.check_message(MAX_MESSAGE_BYTES)


def test_requests_to_all_nodes_have_a_rate(budget: ClientBudget) -> None:
    for _ in range(2 * REQUESTS_PER_S):
        budget.check_request()
    with pytest.raises(OverBudgetError, match="requests to all nodes a second"):
        budget.check_request()


def test_a_client_waits_for_the_work_beyond_its_share(budget: ClientBudget, clock: Clock) -> None:
    assert budget.note_work(WORK_SHARE) == 0.0
    assert budget.note_work(1.5 * WORK_SHARE) == pytest.approx(0.5)
    assert budget.note_work(100 * WORK_SHARE) == 1.0  # the end of a client is noticed soon
    clock.now_s += 100.5
    assert budget.note_work(0.0) == 0.0


def test_a_message_that_was_refused_costs_its_client_time() -> None:
    assert ClientBudget.refusal_pause_s(10) == 1 / MESSAGES_PER_S
    assert ClientBudget.refusal_pause_s(BYTES_PER_S) == 1.0


def test_an_amount_above_the_burst_is_possible_after_a_pause(clock: Clock) -> None:
    rate = Rate(1.0, clock=clock)
    assert rate.take(5.0)
    assert not rate.take(1.0)
    clock.now_s += 5.0
    assert rate.take(2.0)


def test_one_machine_cannot_keep_the_others_away() -> None:
    clients = Clients(3, 2)
    clients.add("10.0.0.7")
    clients.add("10.0.0.7")
    with pytest.raises(OverBudgetError, match=r"^10\.0\.0\.7 has 2 clients already$"):
        clients.add("10.0.0.7")
    clients.add("")
    with pytest.raises(OverBudgetError, match="there are 3 clients already: close one"):
        clients.add("")
    clients.remove("10.0.0.7")
    clients.add("")
