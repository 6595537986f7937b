"""Errors of keystores and certificates. Each message says what to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import SetupError

if TYPE_CHECKING:
    from datetime import datetime
    from pathlib import Path


class SecurityError(SetupError):
    """Root of the errors of keystores and certificates."""


class KeystoreExistsError(SecurityError, FileExistsError):
    """A keystore exists already, or an enclave of a keystore exists already.

    Attributes:
        path: The folder or file that exists.
    """

    def __init__(self, path: Path, sentence: str) -> None:
        self.path = path
        super().__init__(sentence)


class NoKeystoreError(SecurityError, FileNotFoundError):
    """A folder is not a keystore, or a keystore does not have the authority's key."""

    def __init__(self, root: Path, reason: str) -> None:
        self.root, self.reason = root, reason
        super().__init__(f"'{root}' {reason}")


class UnknownEnclaveError(SecurityError, LookupError):
    """A keystore is empty, or it has several enclaves but none with this machine's host name."""

    def __init__(self, root: Path, known: list[str]) -> None:
        self.root, self.known = root, known
        found = ", ".join(known) or "none"
        example = root / "enclaves" / (known[0] if known else "NAME")
        super().__init__(
            f"cannot choose a certificate of '{root}' for this machine (there are: {found}): "
            f"give the path of this machine's folder, such as {example}"
        )


class CertificateRequestError(SecurityError, ValueError):
    """A name, an address or a number of days is not valid for a new certificate."""

    def __init__(self, value: object, reason: str) -> None:
        self.value, self.reason = value, reason
        super().__init__(f"{value!r} {reason}")


class CertificateError(SecurityError):
    """Root of the errors of one certificate.

    Attributes:
        path: The file, or `HOST:PORT` of the hub that showed the certificate.
    """

    def __init__(self, path: Path | str, sentence: str) -> None:
        self.path = path
        super().__init__(sentence)


class MissingFileError(CertificateError, FileNotFoundError):
    """The file of a certificate or key does not exist."""

    def __init__(self, path: Path, what: str) -> None:
        self.what = what
        super().__init__(
            path,
            f"there is no {what} at {path}: copy the machine's whole folder out of the keystore, "
            "or make the folder with `zbot security create_enclave`",
        )


class InvalidFileError(CertificateError, ValueError):
    """A file is not a valid certificate, or is not the key of the certificate beside it."""

    def __init__(self, path: Path, what: str, reason: str) -> None:
        self.what, self.reason = what, reason
        super().__init__(
            path, f"{path} is not a valid {what} ({reason}): copy the machine's whole folder again"
        )


class ValidityPeriodError(CertificateError, ValueError):
    """A certificate has expired, or is not valid yet."""

    def __init__(
        self, path: Path | str, name: str, since: datetime, until: datetime, *, is_expired: bool
    ) -> None:
        self.name, self.since, self.until, self.is_expired = name, since, until, is_expired
        if is_expired:
            problem = f"expired on {until:%Y-%m-%d %H:%M} UTC: renew it with `zbot security "
            problem += "create_enclave --renew`, or set this machine's clock"
        else:
            problem = f"is valid only from {since:%Y-%m-%d %H:%M} UTC on: set this machine's clock"
        super().__init__(path, f"the certificate of {name} ({path}) {problem}")


class ForeignCertificateError(CertificateError, ValueError):
    """A certificate was not signed by the keystore's authority."""

    def __init__(self, path: Path | str, name: str, authority: Path) -> None:
        self.name, self.authority = name, authority
        super().__init__(
            path,
            f"the certificate of {name} ({path}) was not made with the keystore of {authority}: "
            "use certificates of one keystore on both machines",
        )


class CertificateAddressError(CertificateError, ValueError):
    """A hub's certificate does not contain the address of the hub.

    Attributes:
        address: The address at which others reach the hub.
        known: The addresses in the certificate. A client's certificate has no addresses.
    """

    def __init__(self, path: Path | str, name: str, address: str, known: tuple[str, ...]) -> None:
        self.name, self.address, self.known = name, address, known
        problem = f"is for {', '.join(known)}, not for {address}" if known else "names no address"
        super().__init__(
            path,
            f"the certificate of {name} ({path}) {problem}: renew it with "
            f"`zbot security create_enclave --renew KEYSTORE NAME --ip {address}`",
        )


class RefusedCertificateError(SecurityError, PermissionError):
    """The hub at an address does not accept this machine's certificate."""

    def __init__(self, host: str, port: int, reason: str) -> None:
        self.host, self.port, self.reason = host, port, reason
        super().__init__(
            f"{host}:{port} does not accept this machine's certificate ({reason}): use one that "
            "has not expired, from the keystore of that hub"
        )


class NoTlsError(SecurityError, ConnectionError):
    """The program that listens at an address does not use TLS."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"{host}:{port} uses no certificates: join without --keystore, or start the hub there "
            "with --keystore"
        )
