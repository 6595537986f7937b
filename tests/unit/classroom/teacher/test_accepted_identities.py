from __future__ import annotations

import pytest

from zbot.classroom.teacher.accepted_identities import NUMBERS, AcceptedIdentities
from zbot.classroom.teacher.class_record import ClassRecord, user_of
from zbot.security.access import teacher_access


def make_record(pin: str = "4711") -> ClassRecord:
    return ClassRecord("Robots", "master", pin)


def subjects_of(record: ClassRecord) -> dict[str, dict[str, object]]:
    """Return the subjects of the access rules, by the id of the subject."""
    access = teacher_access({user_of(number): number for number in NUMBERS})["access_control"]
    AcceptedIdentities(record).apply(access)
    known = {one["id"] for one in access["subjects"]}
    assert all(set(policy["subjects"]) <= known for policy in access["policies"])
    return {one["id"]: one for one in access["subjects"]}


def test_the_next_owners_of_a_number_are_accepted_in_advance() -> None:
    record = make_record()
    record.assign(7, "first")
    accepted = AcceptedIdentities(record)
    secrets = set()
    for turn in range(9):
        record.assign(7, f"laptop {turn}")
        given = record.credentials(7)
        assert accepted.accepts(7) == (turn < 8)
        assert ((given["user"], given["secret"]) in set(accepted.users())) == (turn < 8)
        secrets.add(given["secret"])
    assert len(secrets) == 9
    assert AcceptedIdentities(record).accepts(7)


def test_a_laptop_that_returns_to_its_number_keeps_its_identity() -> None:
    record = make_record()
    record.assign(7, "first")
    before = record.credentials(7)
    assert not record.assign(7, "first")
    assert record.credentials(7) == before


def test_the_hub_of_a_former_owner_is_known() -> None:
    record = make_record()
    record.assign(7, "first")
    accepted, former = AcceptedIdentities(record), record.credentials(7)["hub_id"]
    assert accepted.former_hub_ids() == set()
    record.assign(7, "second")
    assert accepted.former_hub_ids() == {former}
    assert record.credentials(7)["hub_id"] not in accepted.former_hub_ids()
    assert AcceptedIdentities(record).former_hub_ids() == set()


def test_an_identity_needs_its_user_name_and_its_hub_id() -> None:
    record = make_record()
    record.assign(7, "first")
    given, found = record.credentials(7), subjects_of(record)
    assert found["student7"]["usernames"] == [given["user"]]
    assert found["student7"]["zids"] == [given["hub_id"]]
    assert found["student7-1"]["zids"] != found["student7"]["zids"]
    assert found["teacher"] == {"id": "teacher", "usernames": ["teacher"]}


def test_without_a_pin_the_hub_id_is_the_identity() -> None:
    record = make_record(pin="")
    record.assign(7, "first")
    given, found = record.credentials(7), subjects_of(record)
    assert set(given) == {"hub_id"}
    assert given["hub_id"] in found["student7"]["zids"]  # type: ignore[operator]
    assert found["lobby"] == {"id": "lobby"}
    assert "interfaces" in found["teacher"]


@pytest.mark.parametrize("pin", ["", "4711"])
def test_a_new_period_renews_the_numbers_that_somebody_had(pin: str) -> None:
    record = make_record(pin)
    record.assign(7, "first")
    had, other = record.credentials(7), record.credentials(8)
    record.shares, record.is_open, record.notices = [(7, 8)], True, [{"text": "x"}]
    record.begin_period({7: "Ana"})
    assert record.credentials(7) != had
    assert record.credentials(8) == other
    assert record.register.expected == {7: "Ana"}
    assert (record.shares, record.is_open, record.notices) == ([], False, [])
