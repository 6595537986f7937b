"""Keystores: an authority, and a folder for each machine that it vouches for.

    KEYSTORE/public/ca.cert.pem            what certificates are checked with
    KEYSTORE/private/ca.key.pem            what they are signed with; stays where it was made
    KEYSTORE/enclaves/NAME/cert.pem        a machine's certificate,
                           key.pem         its key,
                           ca.cert.pem     and what it checks others with

The words are those of ROS 2's security tools. An enclave's folder is all that its machine needs: it
is copied there, and named with `--keystore`.
"""

from __future__ import annotations

import re
import secrets
import shutil
import socket
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.security.certificate import Facts, KeyPair, Validity, check, issue, make_authority
from zbot.security.errors import (
    EnclaveExistsError,
    EnclaveNameError,
    KeystoreExistsError,
    MissingFileError,
    NoAuthorityKeyError,
    NoKeystoreError,
    SecurityError,
    UnknownEnclaveError,
)
from zbot.security.secret import make_private_folder, write_private

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

AUTHORITY_DAYS = 3650
MACHINE_DAYS = 365  #: one school year

_AUTHORITY = "ca.cert.pem"
_CERTIFICATE = "cert.pem"
_KEY = "key.pem"
_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]*(/[A-Za-z0-9_][A-Za-z0-9_.-]*)*")
_LONGEST_NAME = 64  #: of a common name (RFC 5280)


class KeystoreWriteError(SecurityError, OSError):
    """A file of a keystore cannot be written or read."""

    def __init__(self, path: Path, error: OSError) -> None:
        self.path = path
        super().__init__(f"cannot use {path}: {error.strerror or error}")


@dataclass(frozen=True)
class Identity:
    """What a machine shows to others: its own folder of a keystore."""

    folder: Path

    @property
    def authority(self) -> Path:
        """File of the certificate that others are checked with."""
        return self.folder / _AUTHORITY

    @property
    def certificate(self) -> Path:
        """File of the machine's certificate."""
        return self.folder / _CERTIFICATE

    @property
    def key(self) -> Path:
        """File of its key."""
        return self.folder / _KEY

    def check(self) -> Facts:
        """Return what the certificate says, having checked all that other machines will check.

        Raises:
            CertificateError: It is missing, damaged, expired, foreign, ...
        """
        return check(self.certificate, self.key, self.authority)


class Keystore:
    """A folder with an authority and the machines it vouches for.

    Args:
        root: The folder.

    Raises:
        NoKeystoreError: It is none.
    """

    def __init__(self, root: Path) -> None:
        self.root = root
        if not is_keystore(root):
            raise NoKeystoreError(root)

    @classmethod
    def create(cls, root: Path, validity: Validity | None = None) -> Keystore:
        """Make a keystore with a new authority.

        Raises:
            KeystoreExistsError: There is something in the folder.
            KeystoreWriteError: It cannot be written.
        """
        if is_keystore(root):
            raise KeystoreExistsError(root, "keystore")
        if root.exists() and (not root.is_dir() or any(root.iterdir())):
            raise KeystoreExistsError(root, "folder" if root.is_dir() else "file")
        made = make_authority(validity or Validity.days(AUTHORITY_DAYS))
        try:
            make_private_folder(root)
            for name in ("public", "private", "enclaves"):
                make_private_folder(root / name)
            write_private(root / "private" / "ca.key.pem", made.key)
            # Last: from here on it is a keystore.
            write_private(root / "public" / _AUTHORITY, made.certificate)
        except OSError as exc:
            raise KeystoreWriteError(root, exc) from exc
        return cls(root)

    def issue(
        self,
        name: str,
        addresses: Iterable[str] = (),
        validity: Validity | None = None,
        *,
        renew: bool = False,
    ) -> Identity:
        """Make a key and a certificate for a machine.

        Args:
            name: Such as `ana` or `/robots/one`.
            addresses: Host names and IP addresses at which others join it; none for a machine
                that only joins.
            validity: A year by default.
            renew: Replace what there is.

        Raises:
            EnclaveNameError: The name cannot be one.
            EnclaveExistsError: There is one of that name.
            NoAuthorityKeyError: The keystore has no key to sign with.
            SecurityError: An address or the validity makes no sense.
        """
        plain = enclave_name(name)
        target = self.root / "enclaves" / plain
        if (target / _CERTIFICATE).exists() and not renew:
            raise EnclaveExistsError(f"/{plain}", target)
        authority = self._authority()
        pair = issue(authority, plain, addresses, validity or Validity.days(MACHINE_DAYS))
        try:
            _place(target, pair, authority.certificate)
        except OSError as exc:
            raise KeystoreWriteError(target, exc) from exc
        return Identity(target)

    def enclaves(self) -> list[str]:
        """Return the names of all machines, sorted, each with a slash before it."""
        folder = self.root / "enclaves"
        found = (file.parent.relative_to(folder) for file in folder.rglob(_CERTIFICATE))
        return sorted(f"/{path.as_posix()}" for path in found if not _is_draft(path))

    def _authority(self) -> KeyPair:
        key = self.root / "private" / "ca.key.pem"
        try:
            return KeyPair(key.read_bytes(), (self.root / "public" / _AUTHORITY).read_bytes())
        except FileNotFoundError:
            raise NoAuthorityKeyError(self.root) from None
        except OSError as exc:
            raise KeystoreWriteError(key, exc) from exc


def is_keystore(root: Path) -> bool:
    """Return whether a folder is a keystore."""
    return (root / "public" / _AUTHORITY).is_file() and (root / "enclaves").is_dir()


def enclave_name(name: str) -> str:
    """Return a machine's name without its first slash.

    Raises:
        EnclaveNameError: It cannot be one: it would not stay inside the keystore, for instance.
    """
    plain = name.removeprefix("/")
    if not _NAME.fullmatch(plain) or len(plain) > _LONGEST_NAME:
        raise EnclaveNameError(name)
    return plain


def identity(folder: Path) -> Identity:
    """Return what this machine shows to others.

    Args:
        folder: A machine's folder; or a keystore, whose only machine is meant, or the one that has
            this machine's host name.

    Raises:
        UnknownEnclaveError: It is a keystore, and it is not clear who of it is meant.
        MissingFileError: It is neither.
    """
    if not is_keystore(folder):
        if not folder.is_dir():
            raise MissingFileError(folder, "keystore")
        return Identity(folder)
    known = [name.removeprefix("/") for name in Keystore(folder).enclaves()]
    host = socket.gethostname()
    chosen = known[0] if len(known) == 1 else host
    if chosen not in known:
        raise UnknownEnclaveError(folder, known)
    return Identity(folder / "enclaves" / chosen)


def _place(target: Path, pair: KeyPair, authority: bytes) -> None:
    """Put a machine's files into a folder that is not there half-filled at any moment."""
    make_private_folder(target.parent)
    draft = target.with_name(f".{target.name}.{secrets.token_hex(4)}")
    make_private_folder(draft)
    try:
        write_private(draft / _AUTHORITY, authority)
        write_private(draft / _KEY, pair.key)
        write_private(draft / _CERTIFICATE, pair.certificate)
        _swap(draft, target)
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def _swap(draft: Path, target: Path) -> None:
    if not target.exists():
        draft.rename(target)
        return
    # A folder may hold those of other machines too (/robots and /robots/one), so its files move.
    for name in (_AUTHORITY, _KEY, _CERTIFICATE):
        (draft / name).replace(target / name)


def _is_draft(path: Path) -> bool:
    return any(part.startswith(".") for part in path.parts)
