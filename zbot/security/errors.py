"""What can go wrong with keystores and certificates, each in a sentence that says what to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import SetupError

if TYPE_CHECKING:
    from datetime import datetime
    from pathlib import Path


class SecurityError(SetupError):
    """Root of what can go wrong with keystores and certificates."""


class NoCryptographyError(SecurityError, ImportError):
    """The package that makes and reads certificates is not installed."""

    def __init__(self) -> None:
        super().__init__("certificates need one more package: pip install 'zbot[security]'")


class KeystoreExistsError(SecurityError, FileExistsError):
    """A keystore would be made where something is."""

    def __init__(self, root: Path, what: str) -> None:
        self.root = root
        super().__init__(f"Unable to create keystore: {what} '{root}' already exists")


class NoKeystoreError(SecurityError, FileNotFoundError):
    """A folder is no keystore."""

    def __init__(self, root: Path) -> None:
        self.root = root
        super().__init__(
            f"'{root}' is not a valid keystore: `zbot security create_keystore {root}` makes one"
        )


class NoAuthorityKeyError(SecurityError, FileNotFoundError):
    """A keystore can check certificates, but not make any."""

    def __init__(self, root: Path) -> None:
        self.root = root
        super().__init__(
            f"'{root}' has no key to sign with (private/ca.key.pem): "
            "make certificates where the keystore was created"
        )


class EnclaveNameError(SecurityError, ValueError):
    """A name cannot be an enclave's."""

    def __init__(self, name: str) -> None:
        self.name = name
        super().__init__(
            f"{name!r} is not a valid enclave name: use words of letters, digits, '.', '_' and "
            "'-', such as /ana or /robots/one, at most 64 characters"
        )


class EnclaveExistsError(SecurityError, FileExistsError):
    """A certificate of that name was made before."""

    def __init__(self, name: str, folder: Path) -> None:
        self.name, self.folder = name, folder
        super().__init__(
            f"Unable to create enclave: '{name}' already exists in {folder}; "
            "--renew replaces its key and certificate"
        )


class UnknownEnclaveError(SecurityError, LookupError):
    """A keystore has several certificates, or none, and it is not said which to use."""

    def __init__(self, root: Path, known: list[str]) -> None:
        self.root, self.known = root, known
        found = ", ".join(known) or "none"
        super().__init__(
            f"which certificate of '{root}' is this machine's (there are: {found})? "
            f"Name its folder, such as {root / 'enclaves' / (known[0] if known else 'NAME')}"
        )


class AddressNameError(SecurityError, ValueError):
    """Something is neither a host's name nor an IP address."""

    def __init__(self, text: str) -> None:
        self.text = text
        super().__init__(f"{text!r} is neither a host's name nor an IP address")


class ValidityError(SecurityError, ValueError):
    """A certificate cannot be valid for that long."""

    def __init__(self, days: int, most: int) -> None:
        self.days, self.most = days, most
        super().__init__(f"a certificate is valid for 1 to {most} days, not {days}")


class CertificateError(SecurityError):
    """Root of what can be wrong with a certificate.

    Attributes:
        path: The file, or who showed the certificate.
    """

    def __init__(self, path: Path | str, sentence: str) -> None:
        self.path = path
        super().__init__(sentence)


class MissingFileError(CertificateError, FileNotFoundError):
    """A certificate or key is not there."""

    def __init__(self, path: Path, what: str) -> None:
        self.what = what
        super().__init__(
            path,
            f"there is no {what} at {path}: copy the machine's whole folder out of the keystore, "
            "or make it with `zbot security create_enclave`",
        )


class UnreadableFileError(CertificateError, ValueError):
    """A file holds no certificate or key."""

    def __init__(self, path: Path, what: str, reason: str) -> None:
        self.what, self.reason = what, reason
        super().__init__(path, f"{path} is no readable {what}: {reason}")


class ForeignKeyError(CertificateError, ValueError):
    """A key and a certificate do not belong together."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            path, f"{path} is not the key of the certificate beside it: copy the whole folder again"
        )


class ExpiredCertificateError(CertificateError, ValueError):
    """A certificate's time is over."""

    def __init__(self, path: Path | str, name: str, until: datetime) -> None:
        self.name, self.until = name, until
        super().__init__(
            path,
            f"the certificate of {name} ({path}) expired on {until:%Y-%m-%d %H:%M} UTC: "
            "renew it with `zbot security create_enclave --renew`, or set this machine's clock",
        )


class EarlyCertificateError(CertificateError, ValueError):
    """A certificate's time has not come."""

    def __init__(self, path: Path | str, name: str, since: datetime) -> None:
        self.name, self.since = name, since
        super().__init__(
            path,
            f"the certificate of {name} ({path}) is valid only from {since:%Y-%m-%d %H:%M} UTC on: "
            "is this machine's clock right?",
        )


class ForeignCertificateError(CertificateError, ValueError):
    """A certificate was signed by somebody else than the keystore's authority."""

    def __init__(self, path: Path | str, name: str, authority: Path) -> None:
        self.name, self.authority = name, authority
        super().__init__(
            path,
            f"the certificate of {name} ({path}) was not made with the keystore of {authority}: "
            "both machines need certificates from one keystore",
        )


class NoServerCertificateError(CertificateError, ValueError):
    """A certificate was made for a machine that joins, and is used where others join."""

    def __init__(self, path: Path | str, name: str) -> None:
        self.name = name
        super().__init__(
            path,
            f"the certificate of {name} ({path}) names no address, so others cannot join it: "
            "make one with `zbot security create_enclave KEYSTORE NAME --ip ADDRESS`",
        )


class WrongAddressError(CertificateError, ValueError):
    """A hub's certificate is for other addresses than the one it is reached at."""

    def __init__(self, path: Path | str, name: str, address: str, known: list[str]) -> None:
        self.name, self.address, self.known = name, address, known
        super().__init__(
            path,
            f"the certificate of {name} ({path}) is for {', '.join(known)}, not for {address}: "
            f"renew it with `zbot security create_enclave --renew KEYSTORE NAME --ip {address}`",
        )


class RefusedCertificateError(SecurityError, PermissionError):
    """The other side does not accept this machine's certificate."""

    def __init__(self, host: str, port: int, reason: str) -> None:
        self.host, self.port, self.reason = host, port, reason
        super().__init__(
            f"{host}:{port} does not accept this machine's certificate ({reason}): "
            "it has to come from the keystore that is used there, and not be expired"
        )


class NoTlsError(SecurityError, ConnectionError):
    """What listens does not speak TLS."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"{host}:{port} uses no certificates: join without --keystore, or have the hub there "
            "started with one"
        )
