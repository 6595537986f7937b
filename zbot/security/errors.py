"""Errors of keystores and certificates. Each message says what to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import SetupError

if TYPE_CHECKING:
    from datetime import datetime
    from pathlib import Path


class SecurityError(SetupError):
    """Root of the errors of keystores and certificates."""


def no_keystore_error(root: Path, reason: str) -> SecurityError:
    """Return the error that a folder is no keystore, or has no key of the authority."""
    return SecurityError(f"'{root}' {reason}")


def unknown_enclave_error(root: Path, known: list[str]) -> SecurityError:
    """Return the error that a keystore has not exactly one enclave, and none of this machine."""
    found = ", ".join(known) or "none"
    example = root / "enclaves" / (known[0] if known else "NAME")
    return SecurityError(
        f"cannot choose a certificate of '{root}' for this machine (there are: {found}): "
        f"give the path of this machine's folder, such as {example}"
    )


def certificate_request_error(value: object, reason: str) -> SecurityError:
    """Return the error that a certificate cannot be made for a name, an address or some days."""
    return SecurityError(f"{value!r} {reason}")


def missing_file_error(path: Path, what: str) -> SecurityError:
    """Return the error that the file of a certificate or key does not exist."""
    return SecurityError(
        f"there is no {what} at {path}: copy the machine's whole folder out of the keystore, "
        "or make the folder with `zbot security create_enclave`",
    )


def invalid_file_error(path: Path, what: str, reason: str) -> SecurityError:
    """Return the error that a file is not a valid certificate, or not its key."""
    return SecurityError(
        f"{path} is not a valid {what} ({reason}): copy the machine's whole folder again"
    )


def validity_period_error(
    path: Path | str, name: str, since: datetime, until: datetime, *, is_expired: bool
) -> SecurityError:
    """Return the error that a certificate has expired, or is not valid yet."""
    if is_expired:
        problem = f"expired on {until:%Y-%m-%d %H:%M} UTC: renew it with `zbot security "
        problem += "create_enclave --renew`, or set this machine's clock"
    else:
        problem = f"is valid only from {since:%Y-%m-%d %H:%M} UTC on: set this machine's clock"
    return SecurityError(f"the certificate of {name} ({path}) {problem}")


def foreign_certificate_error(path: Path | str, name: str, authority: Path) -> SecurityError:
    """Return the error that a certificate was not signed by the keystore's authority."""
    return SecurityError(
        f"the certificate of {name} ({path}) was not made with the keystore of {authority}: "
        "use certificates of one keystore on both machines",
    )


def certificate_address_error(
    path: Path | str, name: str, address: str, known: tuple[str, ...]
) -> SecurityError:
    """Return the error that a hub's certificate does not contain the address of the hub."""
    problem = f"is for {', '.join(known)}, not for {address}" if known else "names no address"
    return SecurityError(
        f"the certificate of {name} ({path}) {problem}: renew it with "
        f"`zbot security create_enclave --renew KEYSTORE NAME --ip {address}`",
    )


def refused_certificate_error(host: str, port: int, reason: str) -> SecurityError:
    """Return the error that the hub at an address does not accept this machine's certificate."""
    return SecurityError(
        f"{host}:{port} does not accept this machine's certificate ({reason}): use one that "
        "has not expired, from the keystore of that hub"
    )


def no_tls_error(host: str, port: int) -> SecurityError:
    """Return the error that the program that listens at an address does not use TLS."""
    return SecurityError(
        f"{host}:{port} uses no certificates: join without --keystore, or start the hub there "
        "with --keystore"
    )


def silent_tls_error(host: str, port: int) -> SecurityError:
    """Return the error that the program that listens at an address does not answer with TLS."""
    return SecurityError(
        f"{host}:{port} does not answer with a certificate: try again in a moment if the network "
        "is slow; if the hub there uses no certificates, join without --keystore, or start it "
        "with --keystore"
    )
