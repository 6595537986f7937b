from __future__ import annotations

from zbot.observer.shared_entities import SharedEntities


def test_last_release_destroys_the_entity() -> None:
    shared, ended = SharedEntities(), list[str]()
    first = shared.get("a", lambda: "thing", ended.append)
    second = shared.get("a", lambda: "another", ended.append)
    assert first.entity is second.entity
    first.release()
    first.release()
    assert ended == []
    assert len(shared) == 1
    second.release()
    assert ended == ["thing"]
    assert len(shared) == 0


def test_entity_is_made_again_after_its_end() -> None:
    shared, made = SharedEntities(), iter(range(9))
    with shared.get("a", lambda: next(made), lambda _: None) as reference:
        assert reference.entity == 0
    assert shared.get("a", lambda: next(made), lambda _: None).entity == 1
