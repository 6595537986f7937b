"""Package index on this machine, with wheels that contain nothing."""

from __future__ import annotations

import contextlib
import hashlib
import threading
import zipfile
from collections import defaultdict
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from pathlib import Path


def write_wheel(
    folder: Path, file: str, requires: Sequence[str] = (), extras: Sequence[str] = ()
) -> Path:
    """Write a wheel that has requirements and nothing else."""
    name, version, *tag = file.removesuffix(".whl").split("-")
    info = f"{name}-{version}.dist-info"
    metadata = [f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}"]
    metadata += [f"Provides-Extra: {extra}" for extra in extras]
    metadata += [f"Requires-Dist: {requirement}" for requirement in requires]
    entries = {
        f"{name}.py": "",
        f"{info}/METADATA": "\n".join(metadata) + "\n",
        f"{info}/WHEEL": f"Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: {'-'.join(tag)}\n",
    }
    record = "".join(f"{entry},,\n" for entry in (*entries, f"{info}/RECORD"))
    folder.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(folder / file, "w") as archive:
        for entry, text in {**entries, f"{info}/RECORD": record}.items():
            archive.writestr(zipfile.ZipInfo(entry), text)
    return folder / file


class _Handler(SimpleHTTPRequestHandler):
    fetched: list[str]

    def do_GET(self) -> None:
        self.fetched.append(self.path)
        super().do_GET()

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002 - the base class
        """Write nothing."""


class FakeIndex:
    """Package index with the wheels in a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.fetched: list[str] = []  #: the paths that were asked for
        handler = type("Handler", (_Handler,), {"fetched": self.fetched})
        serve: Any = partial(handler, directory=str(folder))
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), serve)

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self._server.server_port}/simple/"

    def add(self, *files: str, requires: Sequence[str] = ()) -> None:
        for file in files:
            write_wheel(self.folder / "files", file, requires)

    def fetched_wheels(self) -> list[str]:
        return sorted(path.rpartition("/")[2] for path in self.fetched if path.endswith(".whl"))

    def write_pages(self) -> None:
        pages = defaultdict(list)
        for wheel in sorted((self.folder / "files").iterdir()):
            digest = hashlib.sha256(wheel.read_bytes()).hexdigest()
            link = f'<a href="/files/{wheel.name}#sha256={digest}">{wheel.name}</a>'
            pages[wheel.name.split("-")[0].replace("_", "-")].append(link)
        for name, links in pages.items():
            page = self.folder / "simple" / name / "index.html"
            page.parent.mkdir(parents=True, exist_ok=True)
            page.write_text(f"<!DOCTYPE html><html><body>{''.join(links)}</body></html>")

    @contextlib.contextmanager
    def serving(self) -> Iterator[None]:
        self.write_pages()
        thread = threading.Thread(target=self._server.serve_forever, args=(0.05,))
        thread.start()
        try:
            yield
        finally:
            self._server.shutdown()
            thread.join()
            self._server.server_close()
