"""Server of a bundle."""

from __future__ import annotations

import http.client
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import pytest

from zbot.classroom.bundle import manifest
from zbot.classroom.bundle.errors import BundleError
from zbot.classroom.bundle.first_page import first_page
from zbot.classroom.bundle.manifest import Manifest
from zbot.classroom.bundle.server import BundleServer

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

_WHEEL = "wheels/zbot-0.1.0-py3-none-any.whl"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a bundle with two files, and with a file beside it."""
    usb = tmp_path / "usb"
    (usb / "wheels").mkdir(parents=True)
    (usb / _WHEEL).write_bytes(b"wheel" * 100_000)
    (usb / "secret.txt").write_text("not in the manifest")
    (tmp_path / "outside.txt").write_text("outside")
    files = manifest.digests(usb, [_WHEEL])
    (usb / "index.html").write_text(first_page("0.1.0", files))
    Manifest("0.1.0", [], {}, files | manifest.digests(usb, ["index.html"])).save(usb)
    return usb


@pytest.fixture
def server(folder: Path) -> Iterator[BundleServer]:
    server = BundleServer(folder, "127.0.0.1", 0)
    thread = threading.Thread(target=server.serve_forever, args=(0.05,))
    thread.start()
    yield server
    server.shutdown()
    thread.join()
    server.server_close()


def ask(server: BundleServer, path: str, method: str = "GET") -> tuple[int, bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=10)
    try:
        connection.request(method, path)
        answer = connection.getresponse()
        return answer.status, answer.read()
    finally:
        connection.close()


def test_the_first_page_lists_the_wheels_with_their_hashes(server: BundleServer) -> None:
    status, page = ask(server, "/")
    assert status == 200
    assert f'<a href="{_WHEEL}#sha256='.encode() in page
    assert ask(server, f"/{_WHEEL}?a=b") == (200, b"wheel" * 100_000)
    assert ask(server, f"/{_WHEEL}", "HEAD") == (200, b"")


@pytest.mark.parametrize(
    "path",
    [
        "/secret.txt",
        "/../outside.txt",
        "/%2e%2e/outside.txt",
        "/wheels/../secret.txt",
        "/wheels/..%2f..%2foutside.txt",
        "/..%5coutside.txt",
        "//etc/passwd",
        "//[",
        "/wheels",
        "/wheels/",
        "/%00",
    ],
)
def test_only_files_of_the_manifest_are_served(server: BundleServer, path: str) -> None:
    assert ask(server, path)[0] == 404


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE"])
def test_nothing_can_be_written(server: BundleServer, method: str) -> None:
    assert ask(server, "/index.html", method)[0] == 501


def test_thirty_laptops_are_served_at_once(server: BundleServer) -> None:
    with ThreadPoolExecutor(30) as pool:
        answers = list(pool.map(lambda _: ask(server, f"/{_WHEEL}"), range(60)))
    assert all(answer == (200, b"wheel" * 100_000) for answer in answers)


def test_the_next_port_is_used_if_one_is_taken(server: BundleServer, folder: Path) -> None:
    other = BundleServer(folder, "127.0.0.1", server.server_port)
    assert server.server_port < other.server_port <= server.server_port + 100
    other.server_close()


def test_an_address_of_another_machine_is_one_sentence(folder: Path) -> None:
    with pytest.raises(BundleError, match=r"cannot listen on 192\.0\.2\.1:"):
        BundleServer(folder, "192.0.2.1", 0)


def test_a_folder_without_a_manifest_is_no_bundle(tmp_path: Path) -> None:
    with pytest.raises(BundleError, match="is not a complete bundle"):
        BundleServer(tmp_path, "127.0.0.1", 0)


@pytest.mark.parametrize("name", ["../outside.txt", "/etc/passwd", "a\\b", "C:x", ""])
def test_a_manifest_with_a_path_out_of_the_folder_is_damaged(folder: Path, name: str) -> None:
    Manifest("0.1.0", [], {}, {name: "0"}).save(folder)
    with pytest.raises(BundleError, match="damaged"):
        manifest.load(folder)
