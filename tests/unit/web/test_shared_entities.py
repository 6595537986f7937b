from __future__ import annotations

from zbot.web.lease import Leases


def test_thing_is_shared_and_ends_with_its_last_holder() -> None:
    leases, ended = Leases(), list[str]()
    first = leases.get("a", lambda: "thing", ended.append)
    second = leases.get("a", lambda: "another", ended.append)
    assert first.entity is second.entity
    first.release()
    first.release()
    assert ended == []
    assert len(leases) == 1
    second.release()
    assert ended == ["thing"]
    assert len(leases) == 0


def test_thing_is_made_anew_after_its_end() -> None:
    leases, made = Leases(), iter(range(9))
    with leases.get("a", lambda: next(made), lambda _: None) as lease:
        assert lease.entity == 0
    assert leases.get("a", lambda: next(made), lambda _: None).entity == 1
