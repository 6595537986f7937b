"""Service of a bundle in a class: a process in the background until the class is closed.

`python -m zbot.classroom.bundle.service FOLDER HOST` is this process.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.classroom.bundle import manifest
from zbot.classroom.bundle.errors import BundleError
from zbot.classroom.bundle.server import BundleServer
from zbot.classroom.hub import running_hub
from zbot.security.secret import make_private_folder, write_private
from zbot.text.json_reader import read_json_object
from zbot.transport import background_process, membership

if TYPE_CHECKING:
    from zbot.transport.membership import Membership

_PAUSE_S = 1.0
_END_S = 5.0
_LOCK = "bundle"


@dataclass(frozen=True)
class Served:
    """A bundle that this machine serves."""

    folder: str
    host: str
    port: int
    extras: list[str]

    @property
    def address(self) -> str:
        """The address of the first page."""
        return f"http://{self.host}:{self.port}/"

    @property
    def words(self) -> str:
        """The line of a student, without the name of Python in front."""
        package = f'"zbot[{",".join(self.extras)}]"' if self.extras else "zbot"
        return (
            f"-m pip install --no-index --trusted-host {self.host} "
            f"--find-links {self.address} {package}"
        )

    def document(self) -> dict[str, str]:
        """Return the facts for `--json`."""
        return {
            "address": self.address,
            "folder": self.folder,
            "windows": f"py {self.words}",
            "others": f"python3 {self.words}",
        }


def _state_path() -> Path:
    return membership.folder() / "bundle.json"


def find() -> Served | None:
    """Return the bundle that this machine serves now, or `None`."""
    try:
        with background_process.lock_path(_LOCK).open("r+", encoding="utf-8") as file:
            if background_process.lock(file):
                return None
        return Served(**read_json_object(_state_path().read_bytes()))
    except (OSError, ValueError, TypeError):
        return None


def start(folder: Path, host: str) -> Served:
    """Serve a bundle until the class is closed, and return where it is.

    Raises:
        BundleError: Another bundle is served, or the server cannot listen.
    """
    folder = folder.absolute()
    served = find()
    if served is not None and Path(served.folder) != folder:
        raise BundleError(
            f"this class serves the bundle {served.folder}: `zbot class stop` ends that"
        )
    if served is not None:
        return served
    make_private_folder(membership.folder())
    process = background_process.start(
        *("zbot.classroom.bundle.service", str(folder), host),
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=membership.folder(),
    )
    assert process.stdout is not None
    with process.stdout as lines:
        said = [line.strip() for line in lines]
    found = find()
    if running_hub.READY not in said or found is None:
        process.wait(_END_S)
        raise BundleError(f"the bundle is not served: {said[-1] if said else 'it gave no reason'}")
    background_process.forget(process)
    return found


def serve(folder: Path, host: str) -> None:
    """Serve a bundle until the class is closed."""
    with background_process.lock_path(_LOCK).open("a", encoding="utf-8") as file:
        if not background_process.lock(file):
            raise BundleError("another process serves a bundle")
        server = BundleServer(folder, host)
        extras = manifest.load(folder).extras
        served = Served(str(folder), host, server.server_port, extras)
        write_private(_state_path(), json.dumps(asdict(served)).encode())
        thread = threading.Thread(target=server.serve_forever, name="zbot bundle server")
        thread.start()
        running_hub.report_ready()
        opened, pause = membership.load(), threading.Event()
        while _is_open(opened):
            pause.wait(_PAUSE_S)
        server.shutdown()
        thread.join()
        server.server_close()
        _state_path().unlink(missing_ok=True)


def _is_open(opened: Membership | None) -> bool:
    """Return whether this machine still has the class in which the bundle is served."""
    present = membership.load()
    if opened is None or present is None or present.role != "teacher":
        return False
    return present.class_name == opened.class_name


def main() -> int:
    """Run the process, and return the exit code."""
    return running_hub.exit_code(lambda: serve(Path(sys.argv[1]), sys.argv[2]))


if __name__ == "__main__":
    sys.exit(main())
