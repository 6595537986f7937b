"""Keystore: a folder that has a certificate authority and an enclave for each machine.

    KEYSTORE/public/ca.cert.pem            the authority's certificate, which checks certificates
    KEYSTORE/private/ca.key.pem            the authority's key, which signs them (never copied)
    KEYSTORE/enclaves/NAME/cert.pem        a machine's certificate
                           key.pem         its key
                           ca.cert.pem     a copy of the authority's certificate

ROS 2's security tools use the same names. A machine needs only the folder of its enclave. The user
copies this folder to the machine, and gives its path with `--keystore`.
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
    SecurityError,
    certificate_request_error,
    missing_file_error,
    no_keystore_error,
    unknown_enclave_error,
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
_LONGEST_NAME = 64  #: longest common name of a certificate (RFC 5280)


def keystore_write_error(path: Path, error: OSError) -> SecurityError:
    """Return the error that a file of a keystore cannot be written or read."""
    return SecurityError(f"cannot use {path}: {error.strerror or error}")


@dataclass(frozen=True)
class Identity:
    """Folder with a machine's key and certificates."""

    folder: Path

    @property
    def authority(self) -> Path:
        """File of the authority's certificate, used to check other machines."""
        return self.folder / _AUTHORITY

    @property
    def certificate(self) -> Path:
        """File of the machine's certificate."""
        return self.folder / _CERTIFICATE

    @property
    def key(self) -> Path:
        """File of the machine's key."""
        return self.folder / _KEY

    def check(self) -> Facts:
        """Check the certificate as other machines will check it, and return its contents.

        Raises:
            SecurityError: The certificate is not valid (see `certificate.check`).
        """
        return check(self.certificate, self.key, self.authority)


class Keystore:
    """Folder with an authority and the certificates of machines.

    Args:
        root: The folder.

    Raises:
        SecurityError: The folder is not a keystore.
    """

    def __init__(self, root: Path) -> None:
        self.root = root
        if not is_keystore(root):
            reason = (
                f"is not a valid keystore: make one with `zbot security create_keystore {root}`"
            )
            raise no_keystore_error(root, reason)

    @classmethod
    def create(cls, root: Path, validity: Validity | None = None) -> Keystore:
        """Make a keystore with a new authority.

        Raises:
            SecurityError: A file of this name exists, or the folder is not empty, or the folder
                cannot be written.
        """
        if root.exists() and (not root.is_dir() or any(root.iterdir())):
            what = "keystore" if is_keystore(root) else "folder" if root.is_dir() else "file"
            sentence = f"Unable to create keystore: {what} '{root}' already exists"
            raise SecurityError(sentence)
        made = make_authority(validity or Validity.days(AUTHORITY_DAYS))
        try:
            make_private_folder(root)
            for name in ("public", "private", "enclaves"):
                make_private_folder(root / name)
            write_private(root / "private" / "ca.key.pem", made.key)
            # Write this file last, because `is_keystore` returns True when this file exists.
            write_private(root / "public" / _AUTHORITY, made.certificate)
        except OSError as exc:
            raise keystore_write_error(root, exc) from exc
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
            name: The machine's name, such as `ana` or `/robots/one`.
            addresses: Host names and IP addresses at which others join the machine. Leave them out
                for a machine that only joins others.
            validity: The period of the certificate. By default, it ends in a year.
            renew: Replace an existing key and certificate.

        Raises:
            SecurityError: The name or an address is invalid, or a certificate of that name exists,
                and `renew` is False, or the keystore does not have the authority's key, or the
                files cannot be written.
        """
        plain = enclave_name(name)
        target = self.root / "enclaves" / plain
        if (target / _CERTIFICATE).exists() and not renew:
            sentence = f"Unable to create enclave: '/{plain}' already exists in {target}; "
            sentence += "--renew replaces its key and certificate"
            raise SecurityError(sentence)
        authority = self._authority()
        pair = issue(authority, plain, addresses, validity or Validity.days(MACHINE_DAYS))
        try:
            _place(target, pair, authority.certificate)
        except OSError as exc:
            raise keystore_write_error(target, exc) from exc
        return Identity(target)

    def enclaves(self) -> list[str]:
        """Return the sorted names of all machines. Each name has a leading slash."""
        folder = self.root / "enclaves"
        found = (file.parent.relative_to(folder) for file in folder.rglob(_CERTIFICATE))
        return sorted(f"/{path.as_posix()}" for path in found if not _is_draft(path))

    def _authority(self) -> KeyPair:
        key = self.root / "private" / "ca.key.pem"
        try:
            return KeyPair(key.read_bytes(), (self.root / "public" / _AUTHORITY).read_bytes())
        except FileNotFoundError:
            reason = "has no key to sign with (private/ca.key.pem): "
            reason += "make certificates where the keystore was created"
            raise no_keystore_error(self.root, reason) from None
        except OSError as exc:
            raise keystore_write_error(key, exc) from exc


def is_keystore(root: Path) -> bool:
    """Return whether a folder is a keystore."""
    return (root / "public" / _AUTHORITY).is_file() and (root / "enclaves").is_dir()


def enclave_name(name: str) -> str:
    """Return a machine's name without its leading slash.

    Raises:
        SecurityError: The name is invalid, e.g. a path that leads out of the keystore.
    """
    plain = name.removeprefix("/")
    if not _NAME.fullmatch(plain) or len(plain) > _LONGEST_NAME:
        reason = "is not a valid enclave name: use words of letters, digits, '.', '_' and '-', "
        reason += f"such as /ana or /robots/one, at most {_LONGEST_NAME} characters"
        raise certificate_request_error(name, reason)
    return plain


def identity(folder: Path) -> Identity:
    """Return the folder of this machine's key and certificates.

    Args:
        folder: A machine's folder, or a keystore. If a keystore has one enclave, this enclave is
            chosen. Otherwise the enclave with this machine's host name is chosen.

    Raises:
        SecurityError: The folder does not exist, or the keystore is empty, or no enclave has the
            host name.
    """
    if not is_keystore(folder):
        if not folder.is_dir():
            raise missing_file_error(folder, "keystore")
        return Identity(folder)
    known = [name.removeprefix("/") for name in Keystore(folder).enclaves()]
    host = socket.gethostname()
    chosen = known[0] if len(known) == 1 else host
    if chosen not in known:
        raise unknown_enclave_error(folder, known)
    return Identity(folder / "enclaves" / chosen)


def _place(target: Path, pair: KeyPair, authority: bytes) -> None:
    """Write a machine's files into a folder that appears only when it is complete."""
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
    # Replace the files, but keep the folder, because it may contain folders of other machines
    # (/robots/one).
    for name in (_AUTHORITY, _KEY, _CERTIFICATE):
        (draft / name).replace(target / name)


def _is_draft(path: Path) -> bool:
    return any(part.startswith(".") for part in path.parts)
