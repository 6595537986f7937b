"""Bundles from a package index on this machine."""

from __future__ import annotations

import shutil
from types import SimpleNamespace
from typing import TYPE_CHECKING

import pytest

from zbot.classroom.bundle import download, manifest
from zbot.classroom.bundle.errors import BundleError
from zbot.classroom.bundle.making import BundleOptions, make_bundle
from zbot.classroom.bundle.target import parse_targets

if TYPE_CHECKING:
    from pathlib import Path

    from tests.unit.classroom.bundle.index import FakeIndex


def options(folder: Path, wheel: Path, systems: str, pythons: str, *extras: str) -> BundleOptions:
    return BundleOptions(folder, parse_targets(systems, pythons), list(extras), wheel)


def wheels(made: manifest.Manifest, target: str) -> list[str]:
    return [name.split("-")[0] for name in made.targets[target]["wheels"]]


def test_markers_are_those_of_the_target(index: FakeIndex, wheel: Path, tmp_path: Path) -> None:
    wanted = options(tmp_path / "usb", wheel, "windows,linux-x86_64", "3.10,3.13")
    made = make_bundle(wanted, print)
    assert wheels(made, "windows-x86_64-3.13") == ["ansi", "pip", "plain", "zbot"]
    assert wheels(made, "windows-x86_64-3.10") == ["ansi", "backport", "pip", "plain", "zbot"]
    assert wheels(made, "linux-x86_64-3.13") == ["pip", "plain", "zbot"]
    assert manifest.load(tmp_path / "usb") == made
    assert not made.damaged(tmp_path / "usb")
    assert index.address not in (tmp_path / "usb" / "bundle.json").read_text()


@pytest.mark.usefixtures("index")
def test_an_extra_without_wheels_is_left_out_and_named(wheel: Path, tmp_path: Path) -> None:
    said: list[str] = []
    wanted = options(tmp_path / "usb", wheel, "linux", "3.13", "web", "sim")
    made = make_bundle(wanted, said.append)
    assert made.targets["linux-x86_64-3.13"]["extras"] == ["web", "sim"]
    assert made.targets["linux-aarch64-3.13"]["extras"] == ["web"]
    assert made.extras == ["web"]
    left_out = [line for line in said if line.startswith("left out")]
    assert len(left_out) == 1
    assert "sim for linux-aarch64-3.13, because" in left_out[0]
    assert "fast" in left_out[0]
    best = [name for name in made.files if "fast" in name]
    assert best == ["wheels/fast-3.0-cp313-cp313-manylinux_2_28_x86_64.whl"]


def test_what_is_whole_is_not_fetched_again_and_what_is_damaged_is(
    index: FakeIndex, wheel: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "usb"
    wanted = options(folder, wheel, "windows", "3.13")
    make_bundle(wanted, print)
    index.fetched.clear()
    damaged = folder / "wheels" / "plain-1.0-py3-none-any.whl"
    damaged.write_bytes(damaged.read_bytes()[:-1] + b"x")
    (folder / "wheels" / "old-1.0-py3-none-any.whl").write_bytes(b"")
    (folder / "wheels" / f"ansi.whl{download.PART}").write_bytes(b"half")
    with pytest.raises(BundleError, match=r"plain-1\.0-py3-none-any\.whl: missing, or damaged"):
        manifest.load(folder).check(folder)
    made = make_bundle(wanted, print)
    made.check(folder)
    assert index.fetched_wheels() == ["plain-1.0-py3-none-any.whl"]
    assert len(list((folder / "wheels").iterdir())) == 4


def test_wheels_that_were_changed_on_their_way_are_refused(
    index: FakeIndex, wheel: Path, tmp_path: Path
) -> None:
    changed = index.folder / "files" / "pip-26.0-py3-none-any.whl"
    changed.write_bytes(changed.read_bytes() + b"more")
    with pytest.raises(BundleError, match=r"pip-26\.0-py3-none-any\.whl was changed on its way"):
        make_bundle(options(tmp_path / "usb", wheel, "windows", "3.13"), print)
    assert not (tmp_path / "usb" / "bundle.json").exists()


def test_an_index_that_cannot_be_reached_is_one_sentence(
    wheel: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("UV_DEFAULT_INDEX", "http://127.0.0.1:9/simple/")
    monkeypatch.setenv("UV_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setenv("UV_HTTP_RETRIES", "0")
    with pytest.raises(BundleError, match="the package index cannot be reached") as raised:
        make_bundle(options(tmp_path / "usb", wheel, "windows", "3.13"), print)
    assert "\n" not in str(raised.value)


def test_a_folder_that_cannot_be_written_is_one_sentence(wheel: Path, tmp_path: Path) -> None:
    (tmp_path / "usb").write_text("a file")
    with pytest.raises(BundleError, match="usb"):
        make_bundle(options(tmp_path / "usb", wheel, "windows", "3.13"), print)


@pytest.mark.usefixtures("index")
def test_a_full_disk_is_told_before_the_download(
    wheel: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=1))
    with pytest.raises(BundleError, match="has 0 MB free, and the bundle needs 50 MB more"):
        make_bundle(options(tmp_path / "usb", wheel, "windows", "3.13"), print)
    assert [path.name for path in (tmp_path / "usb" / "wheels").iterdir()] == [wheel.name]
