"""Tests of definitions that are read from folders and archives of others."""

from __future__ import annotations

import bz2
import gzip
import io
import lzma
import os
import sys
import tarfile
import zipfile
from typing import TYPE_CHECKING

import pytest

from zbot.interfaces import collection
from zbot.interfaces.collection import DefinitionSourceError, collect

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

MANIFEST = "<package><name>box_msgs</name></package>"
FILES = {
    "box-main/package.xml": MANIFEST,
    "box-main/msg/Box.msg": "int32 size\n",
    "box-main/srv/Open.srv": "---\nbool success\n",
    "box-main/README.md": "x",
    "box-main/scripts/Box.msg": "no definition\n",
}


def tar(files: dict[str, str]) -> bytes:
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w") as archive:
        for name, text in files.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(text.encode())
            archive.addfile(entry, io.BytesIO(text.encode()))
    return stream.getvalue()


def with_headers(files: dict[str, str], count: int) -> bytes:
    stream = io.BytesIO()
    headers = {f"key{number}": "value" for number in range(count)}
    with tarfile.open(fileobj=stream, mode="w", pax_headers=headers) as archive:
        for name in files:
            archive.addfile(tarfile.TarInfo(name))
    return stream.getvalue()


def zipped(files: dict[str, str]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return stream.getvalue()


def as_is(data: bytes) -> bytes:
    return data


@pytest.fixture
def write(tmp_path: Path) -> Callable[[bytes], Path]:
    def write_archive(data: bytes) -> Path:
        path = tmp_path / "archive"
        path.write_bytes(data)
        return path

    return write_archive


@pytest.mark.parametrize("compress", [as_is, gzip.compress, bz2.compress, lzma.compress])
def test_a_tar_archive_is_read(
    compress: Callable[[bytes], bytes], write: Callable[[bytes], Path]
) -> None:
    (package,) = collect(write(compress(tar(FILES))))
    assert package.name == "box_msgs"
    assert package.texts == {"msg/Box.msg": "int32 size\n", "srv/Open.srv": "---\nbool success\n"}


def test_a_zip_archive_and_a_folder_are_read_alike(
    write: Callable[[bytes], Path], tmp_path: Path
) -> None:
    for name, text in {**FILES, "box-main/build/msg/Old.msg": "int32 x\n"}.items():
        (tmp_path / "here" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "here" / name).write_text(text)
    (package,) = collect(tmp_path / "here")
    assert collect(write(zipped(FILES))) == [package]
    assert collect(tmp_path / "here" / "box-main")[0].texts == package.texts


def test_a_folder_without_a_manifest_has_the_name_of_the_package(tmp_path: Path) -> None:
    (tmp_path / "cube_msgs" / "msg").mkdir(parents=True)
    (tmp_path / "cube_msgs" / "msg" / "Cube.msg").write_bytes(b"int32 size  # \xb5m\n")
    assert [package.name for package in collect(tmp_path)] == ["cube_msgs"]
    assert [package.name for package in collect(tmp_path / "cube_msgs")] == ["cube_msgs"]


@pytest.mark.parametrize("pack", [tar, zipped])
@pytest.mark.parametrize(
    ("files", "reason"),
    [
        ({"README.md": "x"}, "there are no .msg, .srv and .action files"),
        ({"../../../etc/msg/passwd.msg": "int32 x"}, "'passwd'"),
        ({"../msg/Box.msg": "int32 x"}, r"package name '\.\.'"),
        ({"a_msgs/msg/../../../Box.msg": "x"}, "there are no .msg"),
        ({"a_msgs/msg/B\x1b[2J.msg": "int32 x"}, r"\\x1b\[2J"),
        ({"a_msgs/msg/Big.msg": "#" * (collection.MAX_FILE + 1)}, "'.*Big.msg' is larger than"),
        ({"x/a/msg/B.msg": "int32 x", "y/a/msg/B.msg": "int32 y"}, "two packages, in 'x/a' and"),
    ],
)
def test_an_archive_that_is_not_right_is_refused(
    pack: Callable[[dict[str, str]], bytes],
    files: dict[str, str],
    reason: str,
    write: Callable[[bytes], Path],
) -> None:
    with pytest.raises(DefinitionSourceError, match=reason):
        collect(write(pack(files)))


def test_links_in_an_archive_are_not_followed(write: Callable[[bytes], Path]) -> None:
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w") as archive:
        for kind in (tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.FIFOTYPE, tarfile.CHRTYPE):
            entry = tarfile.TarInfo("a_msgs/msg/A.msg")
            entry.type, entry.linkname = kind, "/etc/passwd"
            archive.addfile(entry)
    with pytest.raises(DefinitionSourceError, match=r"there are no \.msg"):
        collect(write(stream.getvalue()))


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no named pipes in folders")
def test_a_pipe_in_a_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "msg").mkdir()
    os.mkfifo(tmp_path / "msg" / "A.msg")
    with pytest.raises(DefinitionSourceError, match=r"'A\.msg' is not a file"):
        collect(tmp_path)


def test_a_bomb_ends_at_the_limits(
    write: Callable[[bytes], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(collection, "MAX_UNPACKED", 10**6)
    bomb = tar({**FILES, "zeros": "\0" * 10**6})
    with pytest.raises(DefinitionSourceError, match="its content is larger than 1000000 bytes"):
        collect(write(gzip.compress(bomb)))
    monkeypatch.undo()
    with pytest.raises(DefinitionSourceError, match=r"its content is larger than 1\d{6} bytes"):
        collect(write(bz2.compress(tar({f"a/{number}": "" for number in range(4000)}))))
    with pytest.raises(DefinitionSourceError, match="more than 100 headers for all its files"):
        collect(write(with_headers(FILES, 200)))
    monkeypatch.setattr(collection, "MAX_ENTRIES", 20)
    for pack in (tar, zipped):
        with pytest.raises(DefinitionSourceError, match="more than 20 files and folders"):
            collect(write(pack({f"a/{number}": "" for number in range(30)})))
    monkeypatch.setattr(collection, "MAX_TOTAL", 15)
    for files in (FILES, {"a/package.xml": "<package></package>"}):
        with pytest.raises(DefinitionSourceError, match="its definitions exceed 15 bytes"):
            collect(write(zipped(files)))
    monkeypatch.setattr(collection, "MAX_ARCHIVE", 15)
    with pytest.raises(DefinitionSourceError, match="larger than 15 bytes: unpack it"):
        collect(write(zipped(FILES)))


def test_a_size_that_a_zip_archive_claims_is_not_trusted(write: Callable[[bytes], Path]) -> None:
    data = zipped({"a_msgs/msg/A.msg": "#" * 10**6})
    claimed = data.replace((10**6).to_bytes(4, "little"), (10).to_bytes(4, "little"))
    assert claimed != data
    with pytest.raises(DefinitionSourceError):
        collect(write(claimed))


@pytest.mark.parametrize("data", [b"", b"x" * 600, b"\x1f\x8b", b"PK\x05\x06" + bytes(18)])
def test_other_files_are_refused(data: bytes, write: Callable[[bytes], Path]) -> None:
    with pytest.raises(DefinitionSourceError, match="cannot read definitions from"):
        collect(write(data))
