"""A package index with a small zbot and its dependencies, and no internet."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.unit.classroom.bundle.index import FakeIndex, write_wheel
from zbot.classroom.bundle import making
from zbot.classroom.bundle.own_wheel import Source
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


@pytest.fixture
def index(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[FakeIndex]:
    for name in ("UV_INDEX_URL", "UV_INDEX", "UV_FIND_LINKS", "UV_EXTRA_INDEX_URL"):
        monkeypatch.delenv(name, raising=False)
    fake = FakeIndex(tmp_path / "index")
    monkeypatch.setenv("UV_DEFAULT_INDEX", fake.address)
    monkeypatch.setenv("UV_CACHE_DIR", str(tmp_path / "cache"))
    fake.add("pip-26.0-py3-none-any.whl", "plain-1.0-py3-none-any.whl", "ansi-2.0-py3-none-any.whl")
    fake.add("backport-1.0-py3-none-any.whl")
    fake.add(*(f"fast-3.0-cp313-cp313-{tag}.whl" for tag in ("win_amd64", "manylinux_2_28_x86_64")))
    fake.add("fast-3.0-cp313-cp313-manylinux_2_17_x86_64.whl")
    with fake.serving():
        yield fake


@pytest.fixture
def wheel(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a wheel of zbot that needs little, and let this zbot be no checkout."""
    monkeypatch.setattr(making, "find_source", Source)
    return write_wheel(
        tmp_path / "own",
        f"zbot-{__version__}-py3-none-any.whl",
        [
            "plain>=1",
            'ansi; sys_platform == "win32"',
            'backport; python_version < "3.11"',
            'fast; extra == "sim"',
        ],
        ["sim", "web"],
    )
