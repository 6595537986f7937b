from __future__ import annotations

import threading
from typing import TYPE_CHECKING

import pytest

from zbot.classroom.errors import ClassroomError
from zbot.classroom.hub import running_hub

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))


def test_a_machine_has_one_hub() -> None:
    with running_hub.hub_lock():
        running_hub.write_state("student", ("tcp/127.0.0.1:1",), ())
        found = running_hub.find()
        assert found is not None
        assert found.role == "student"
        with pytest.raises(ClassroomError, match="has a hub already"):
            _run_another_hub()
    assert running_hub.find() is None
    _run_another_hub()


def _run_another_hub() -> None:
    with running_hub.hub_lock():
        return


def test_searching_for_a_hub_does_not_prevent_one_from_starting() -> None:
    over = threading.Event()

    def look() -> None:
        while not over.is_set():
            running_hub.find()

    looker = threading.Thread(target=look)
    looker.start()
    for _ in range(20):
        _run_another_hub()
    over.set()
    looker.join()


def test_without_a_hub_there_is_nothing_to_stop() -> None:
    assert running_hub.find() is None
    assert not running_hub.stop()
