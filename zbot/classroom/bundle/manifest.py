"""Manifest of a bundle: the file `bundle.json`, with the SHA-256 of each other file."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING, Any

from zbot.classroom.bundle.download import is_whole, sha256_of
from zbot.classroom.bundle.errors import BundleError, file_error
from zbot.text.json_reader import JsonError, read_json_object

if TYPE_CHECKING:
    from collections.abc import Iterable

FILE = "bundle.json"
WHEELS = "wheels"  #: folder of the wheels in a bundle


@dataclass(frozen=True)
class Manifest:
    """What a bundle contains."""

    version: str  #: of zbot
    extras: list[str]  #: extras that all targets have
    targets: dict[str, dict[str, Any]]  #: the names of the wheels and the extras of each target
    files: dict[str, str] = field(default_factory=dict)  #: the SHA-256 of each file, by its path

    def document(self) -> dict[str, Any]:
        """Return the content of the file."""
        return {
            "zbot": self.version,
            "extras": self.extras,
            "targets": self.targets,
            "files": self.files,
        }

    def save(self, folder: Path) -> None:
        """Write the file."""
        text = json.dumps(self.document(), indent=1) + "\n"
        (folder / FILE).write_text(text, encoding="utf-8")

    def damaged(self, folder: Path) -> list[str]:
        """Return the paths of the files that are missing or have other bytes."""
        return [name for name, digest in self.files.items() if not is_whole(folder / name, digest)]

    def check(self, folder: Path) -> None:
        """Raise `BundleError` if a file is missing or has other bytes. It names the file."""
        damaged = self.damaged(folder)
        if damaged:
            others = f" and {len(damaged) - 1} other files" if len(damaged) > 1 else ""
            raise BundleError(
                f"{folder / damaged[0]}{others}: missing, or damaged (the SHA-256 is another one): "
                f"`zbot class bundle --out {folder}` with the same options mends the bundle"
            )


def digests(folder: Path, names: Iterable[str]) -> dict[str, str]:
    """Return the SHA-256 of files in a folder."""
    return {name: sha256_of(folder / name) for name in sorted(names)}


def load(folder: Path) -> Manifest:
    """Read the manifest of a bundle.

    Raises:
        BundleError: The folder is not a bundle, or its manifest is damaged.
    """
    path = folder / FILE
    try:
        return parse(path.read_bytes())
    except FileNotFoundError:
        raise BundleError(
            f"{folder} is not a complete bundle: `zbot class bundle --out {folder}` makes it"
        ) from None
    except OSError as error:
        raise file_error(path, error) from error
    except (JsonError, KeyError, TypeError, ValueError, AttributeError) as error:
        raise BundleError(f"{path} is damaged: make the bundle again") from error


def parse(data: bytes) -> Manifest:
    """Return the manifest in the content of a file.

    Raises:
        JsonError: It is not JSON.
        KeyError: A part is missing.
        TypeError: A part has another type.
        ValueError: A path leads out of the folder.
        AttributeError: A part has another type.
    """
    document = read_json_object(data)
    files = {str(name): str(digest) for name, digest in document["files"].items()}
    for name in files:
        _check_path(name)
    targets = {str(name): dict(target) for name, target in document["targets"].items()}
    return Manifest(str(document["zbot"]), list(map(str, document["extras"])), targets, files)


def _check_path(name: str) -> None:
    path = PurePosixPath(name)
    if path.is_absolute() or ".." in path.parts or not path.parts or set(name) & set("\\:\0"):
        raise ValueError(name)
