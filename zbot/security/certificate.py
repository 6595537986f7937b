"""X.509 certificates: functions that make and check certificates.

Keys are on the curve P-256, and signatures are ECDSA with SHA-256. Every TLS library accepts both.
"""

from __future__ import annotations

import ipaddress
import re
from dataclasses import dataclass
from datetime import datetime, timedelta, timezone
from typing import TYPE_CHECKING

from zbot.security.errors import (
    certificate_request_error,
    foreign_certificate_error,
    invalid_file_error,
    missing_file_error,
    validity_period_error,
)

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from cryptography import x509
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey

MAX_DAYS = 3650  #: ten years
AUTHORITY_NAME = "zbot keystore"
#: A certificate is valid from this long before its creation, because other clocks may be slow.
_CLOCK_TOLERANCE = timedelta(days=1)
_HOST_NAME = re.compile(
    r"(?=.{1,253}$)[A-Za-z0-9_]([A-Za-z0-9_-]{0,62})(\.[A-Za-z0-9_][A-Za-z0-9_-]{0,62})*"
)


@dataclass(frozen=True)
class KeyPair:
    """A key and its certificate, both as the content of a PEM file."""

    key: bytes
    certificate: bytes


@dataclass(frozen=True)
class Facts:
    """Contents of a certificate."""

    name: str
    since: datetime
    until: datetime
    addresses: tuple[str, ...]  #: host names and IP addresses at which others reach the machine
    is_server: bool  #: whether other machines may join the machine
    fingerprint: str  #: SHA-256 of the certificate in DER form, in hexadecimal digits


@dataclass(frozen=True)
class Validity:
    """Period in which a certificate is valid."""

    since: datetime
    until: datetime

    @classmethod
    def days(cls, count: int) -> Validity:
        """Return a period of `count` days from now. It begins one day earlier, for slow clocks.

        Raises:
            SecurityError: The number is not from 1 to 3650.
        """
        if not 1 <= count <= MAX_DAYS:
            raise certificate_request_error(count, f"is not a number of days from 1 to {MAX_DAYS}")
        now = datetime.now(timezone.utc)
        return cls(now - _CLOCK_TOLERANCE, now + timedelta(days=count))


def make_authority(validity: Validity) -> KeyPair:
    """Return a new authority: a key that signs certificates, and a certificate that checks them."""
    from cryptography import x509  # noqa: PLC0415 - slow to import
    from cryptography.hazmat.primitives.asymmetric import ec  # noqa: PLC0415 - slow to import

    key = ec.generate_private_key(ec.SECP256R1())
    name = _named(AUTHORITY_NAME)
    usage = _usage(key_cert_sign=True, crl_sign=True)
    builder = (
        _builder(name, name, key, validity)
        .add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
        .add_extension(usage, critical=True)
    )
    return _signed(builder, key, key)


def issue(authority: KeyPair, name: str, addresses: Iterable[str], validity: Validity) -> KeyPair:
    """Return a new key and its certificate.

    Args:
        authority: Key pair that signs the certificate.
        name: The machine's name, which becomes the certificate's common name.
        addresses: Host names and IP addresses at which others reach the machine. A certificate
            without addresses is for a client: it can join other machines, but they cannot join it.
        validity: Period in which the certificate is valid.

    Raises:
        SecurityError: An address is not a host name or an IP address.
    """
    from cryptography import x509  # noqa: PLC0415 - slow to import
    from cryptography.hazmat.primitives.asymmetric import ec  # noqa: PLC0415 - slow to import
    from cryptography.hazmat.primitives.serialization import (  # noqa: PLC0415 - slow to import
        load_pem_private_key,
    )
    from cryptography.x509.oid import ExtendedKeyUsageOID as Purpose  # noqa: PLC0415 - slow to import

    names = [_general_name(address) for address in addresses]
    purposes = [Purpose.CLIENT_AUTH, *([Purpose.SERVER_AUTH] if names else [])]
    signer = load_pem_private_key(authority.key, None)
    issuer = x509.load_pem_x509_certificate(authority.certificate)
    assert isinstance(signer, ec.EllipticCurvePrivateKey)  # make_authority makes only such keys
    key = ec.generate_private_key(ec.SECP256R1())
    builder = (
        _builder(_named(name), issuer.subject, key, validity)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(_usage(digital_signature=True), critical=True)
        .add_extension(x509.ExtendedKeyUsage(purposes), critical=False)
        .add_extension(
            x509.AuthorityKeyIdentifier.from_issuer_public_key(signer.public_key()), critical=False
        )
    )
    if names:
        builder = builder.add_extension(x509.SubjectAlternativeName(names), critical=False)
    return _signed(builder, key, signer)


def _named(name: str) -> x509.Name:
    from cryptography import x509  # noqa: PLC0415 - slow to import
    from cryptography.x509.oid import NameOID  # noqa: PLC0415 - slow to import

    return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, name)])


def _general_name(address: str) -> x509.GeneralName:
    from cryptography import x509  # noqa: PLC0415 - slow to import

    try:
        return x509.IPAddress(ipaddress.ip_address(address))
    except ValueError:
        if not _HOST_NAME.fullmatch(address):
            problem = "is neither a host name nor an IP address"
            raise certificate_request_error(address, problem) from None
        return x509.DNSName(address)


def _usage(
    *, digital_signature: bool = False, key_cert_sign: bool = False, crl_sign: bool = False
) -> x509.KeyUsage:
    from cryptography import x509  # noqa: PLC0415 - slow to import

    return x509.KeyUsage(
        digital_signature=digital_signature,
        key_cert_sign=key_cert_sign,
        crl_sign=crl_sign,
        content_commitment=False,
        key_encipherment=False,
        data_encipherment=False,
        key_agreement=False,
        encipher_only=False,
        decipher_only=False,
    )


def _builder(
    subject: x509.Name, issuer: x509.Name, key: EllipticCurvePrivateKey, validity: Validity
) -> x509.CertificateBuilder:
    from cryptography import x509  # noqa: PLC0415 - slow to import

    identifier = x509.SubjectKeyIdentifier.from_public_key(key.public_key())
    return (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(issuer)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(validity.since)
        .not_valid_after(validity.until)
        .add_extension(identifier, critical=False)
    )


def _signed(
    builder: x509.CertificateBuilder, key: EllipticCurvePrivateKey, signer: EllipticCurvePrivateKey
) -> KeyPair:
    from cryptography.hazmat.primitives import hashes, serialization  # noqa: PLC0415 - slow to import

    certificate = builder.sign(signer, hashes.SHA256())
    private = key.private_bytes(
        serialization.Encoding.PEM,
        serialization.PrivateFormat.PKCS8,
        serialization.NoEncryption(),
    )
    return KeyPair(private, certificate.public_bytes(serialization.Encoding.PEM))


def facts(certificate: Path) -> Facts:
    """Return the contents of a certificate's file.

    Raises:
        SecurityError: The file does not exist or cannot be read.
    """
    return _facts(_certificate(certificate))


def _facts(certificate: x509.Certificate) -> Facts:
    from cryptography import x509  # noqa: PLC0415 - slow to import
    from cryptography.hazmat.primitives import hashes  # noqa: PLC0415 - slow to import
    from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID  # noqa: PLC0415 - slow to import

    names = certificate.subject.get_attributes_for_oid(NameOID.COMMON_NAME)
    extensions = certificate.extensions
    try:
        listed = extensions.get_extension_for_class(x509.SubjectAlternativeName).value
        addresses = tuple(str(address.value) for address in listed)
    except x509.ExtensionNotFound:
        addresses = ()
    try:
        purposes = list(extensions.get_extension_for_class(x509.ExtendedKeyUsage).value)
    except x509.ExtensionNotFound:
        purposes = [ExtendedKeyUsageOID.SERVER_AUTH]
    return Facts(
        str(names[0].value) if names else "nobody",
        certificate.not_valid_before_utc,
        certificate.not_valid_after_utc,
        addresses,
        ExtendedKeyUsageOID.SERVER_AUTH in purposes,
        certificate.fingerprint(hashes.SHA256()).hex(),
    )


def check(certificate: Path, key: Path, authority: Path, now: datetime | None = None) -> Facts:
    """Check a machine's certificate as other machines will check it, and return its contents.

    Args:
        certificate: File of the certificate.
        key: File of the certificate's key.
        authority: File of the certificate of the keystore's authority.
        now: The time at which the certificate must be valid. The default is the present time.

    Raises:
        SecurityError: A file does not exist, or a file is damaged, or the key does not belong to
            the certificate, or the machine's or the authority's certificate has expired, or is not
            valid yet, or another authority signed the certificate.
    """
    moment = now or datetime.now(timezone.utc)
    issuer, own = _certificate(authority), _certificate(certificate)
    _check_key(key, own)
    said = _facts(own)
    if not _is_signed_by(own, issuer):
        raise foreign_certificate_error(certificate, said.name, authority)
    _check_time(authority, _facts(issuer), moment)
    _check_time(certificate, said, moment)
    return said


def check_issued(der: bytes, shown_by: str, authority: Path, now: datetime | None = None) -> Facts:
    """Check a certificate that another machine has shown, and return its contents.

    Args:
        der: The certificate in DER form.
        shown_by: `HOST:PORT` of the other machine, used in error messages.
        authority: File of the certificate of the keystore's authority.
        now: The time at which the certificate must be valid. The default is the present time.

    Raises:
        SecurityError: The certificate is not valid (see `check`).
    """
    from cryptography import x509  # noqa: PLC0415 - slow to import

    try:
        shown = x509.load_der_x509_certificate(der)
        said = _facts(shown)
    except ValueError as exc:
        raise foreign_certificate_error(shown_by, "nobody", authority) from exc
    if not _is_signed_by(shown, _certificate(authority)):
        raise foreign_certificate_error(shown_by, said.name, authority)
    _check_time(shown_by, said, now or datetime.now(timezone.utc))
    return said


def _check_time(path: Path | str, said: Facts, now: datetime) -> None:
    if not said.since <= now <= said.until:
        raise validity_period_error(
            path, said.name, said.since, said.until, is_expired=now > said.until
        )


def _is_signed_by(certificate: x509.Certificate, issuer: x509.Certificate) -> bool:
    from cryptography.exceptions import InvalidSignature  # noqa: PLC0415 - slow to import

    try:
        certificate.verify_directly_issued_by(issuer)
    except (ValueError, TypeError, InvalidSignature):
        return False
    return True


def _check_key(path: Path, certificate: x509.Certificate) -> None:
    from cryptography.hazmat.primitives.serialization import (  # noqa: PLC0415 - slow to import
        load_pem_private_key,
    )

    try:
        key = load_pem_private_key(_content(path, "key"), None)
    except (ValueError, TypeError) as exc:
        raise invalid_file_error(path, "key", "it is damaged or has a password") from exc
    if key.public_key() != certificate.public_key():
        raise invalid_file_error(path, "key", "it does not belong to the certificate beside it")


def _certificate(path: Path) -> x509.Certificate:
    from cryptography import x509  # noqa: PLC0415 - slow to import

    try:
        found = x509.load_pem_x509_certificate(_content(path, "certificate"))
        _facts(found)  # this reads the extensions, which may be damaged too
    except ValueError as exc:
        raise invalid_file_error(path, "certificate", "it is damaged") from exc
    return found


def _content(path: Path, what: str) -> bytes:
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise missing_file_error(path, what) from None
    except OSError as exc:
        raise invalid_file_error(path, what, exc.strerror or str(exc)) from exc
