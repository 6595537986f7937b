"""Verbs of `zbot security`. They make, list and check the certificates of machines."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import typer

from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.listing import AsJson, new_app, print_json

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.security.certificate import Facts, Validity
    from zbot.security.keystore import Identity

    Verb = Callable[..., None]

app = new_app("Make certificates for machines")

Root = Annotated[Path, typer.Argument(metavar="ROOT", help="Folder of the keystore")]
Name = Annotated[str, typer.Argument(metavar="NAME", help="Name of the machine, e.g. /ana")]
Policy = Annotated[Path, typer.Argument(help="Policy file of ROS 2")]
Addresses = Annotated[
    list[str] | None,
    typer.Option(
        "--host", "--ip", help="Address at which others reach the machine; may be repeated"
    ),
]
Days = Annotated[int | None, typer.Option("--days", help="Days until the certificate expires")]
Renew = Annotated[bool, typer.Option("--renew", help="Replace the existing key and certificate")]


def no_policies_error(verb: str) -> CommandError:
    """Return the error that a verb needs ROS 2's permission files, which zbot does not have."""
    hint = "`zbot class start --pin` keeps students out of each other's domains"
    return CommandError(
        f"{verb}: zbot has no permission files; `zbot class` decides who may publish what",
        hint=hint,
    )


def _both_spellings(name: str, **options: Any) -> Callable[[Verb], Verb]:
    """Register a verb under its name in ros2, and under a hidden name with dashes."""

    def register(verb: Verb) -> Verb:
        app.command(name, **options)(verb)
        app.command(name.replace("_", "-"), **{**options, "hidden": True})(verb)
        return verb

    return register


def _validity(days: int | None) -> Validity | None:
    from zbot.security.certificate import Validity  # noqa: PLC0415 - not needed by `--help`

    return None if days is None else Validity.days(days)


@_both_spellings("create_keystore")
def create_keystore(root: Root, days: Days = None) -> None:
    """Create a keystore with a new certificate authority."""
    from zbot.security.keystore import Keystore  # noqa: PLC0415 - not needed by `--help`

    Keystore.create(root, _validity(days))
    print(f"created keystore {root}; keep {root / 'private'} on this machine")


@_both_spellings("create_enclave")
def create_enclave(
    root: Root, name: Name, addresses: Addresses = None, days: Days = None, renew: Renew = False
) -> None:
    """Make the key and certificate of a machine."""
    from zbot.security.keystore import Keystore  # noqa: PLC0415 - not needed by `--help`

    made = Keystore(root).issue(name, addresses or (), _validity(days), renew=renew)
    _print_created(made)


app.command("create_certificate", hidden=True)(create_enclave)
app.command("create-certificate", hidden=True)(create_enclave)


def _print_created(made: Identity) -> None:
    facts = made.check()
    role = (
        f"others join it at {', '.join(facts.addresses)}" if facts.is_server else "it joins others"
    )
    print(f"created {made.folder}: /{facts.name}, valid until {facts.until:%Y-%m-%d}, {role}")


@_both_spellings("list_enclaves")
def list_enclaves(root: Root, as_json: AsJson = False) -> None:
    """List the machines of a keystore."""
    from zbot.security.keystore import Keystore  # noqa: PLC0415 - not needed by `--help`

    names = Keystore(root).enclaves()
    if as_json:
        print_json(names)
        return
    for name in names:
        print(name)


@_both_spellings("check_certificate")
def check_certificate(
    folder: Annotated[
        Path, typer.Argument(metavar="DIR", help="Folder of the machine's certificate")
    ],
    as_json: AsJson = False,
) -> None:
    """Check a certificate as other machines do."""
    from zbot.security.keystore import identity  # noqa: PLC0415 - not needed by `--help`

    facts = identity(folder).check()
    if as_json:
        print_json(_document(facts))
        return
    print(f"name: {facts.name}")
    print(f"valid: {facts.since:%Y-%m-%d %H:%M} to {facts.until:%Y-%m-%d %H:%M} UTC")
    print(f"addresses for others: {', '.join(facts.addresses) or 'none, it joins others'}")


def _document(facts: Facts) -> dict[str, Any]:
    return {
        "name": facts.name,
        "since": facts.since.isoformat(),
        "until": facts.until.isoformat(),
        "addresses": list(facts.addresses),
        "is_server": facts.is_server,
    }


class _ArtifactsCommand(ManyValuesCommand):
    many: ClassVar[frozenset[str]] = frozenset({"-e", "--enclaves", "-p", "--policy-files"})


@_both_spellings("generate_artifacts", cls=_ArtifactsCommand)
def generate_artifacts(
    root: Annotated[
        Path | None,
        typer.Option("-k", "--keystore-root-path", envvar="ROS_SECURITY_KEYSTORE", help="Keystore"),
    ] = None,
    enclaves: Annotated[
        list[str] | None, typer.Option("-e", "--enclaves", help="Names of machines")
    ] = None,
    policy_files: Annotated[
        list[Path] | None,
        typer.Option("-p", "--policy-files", hidden=True, help="Not supported"),
    ] = None,
) -> None:
    """Make the missing keystore and certificates."""
    from zbot.security.keystore import Keystore, enclave_name, is_keystore  # noqa: PLC0415 - not needed by `--help`

    if policy_files:
        raise no_policies_error("generate_artifacts")
    if root is None:
        raise CommandError(
            "no keystore is named: use -k ROOT, or set ROS_SECURITY_KEYSTORE to its folder"
        )
    wanted = [enclave_name(name) for name in enclaves or ()]
    if not is_keystore(root):
        create_keystore(root)
    store = Keystore(root)
    for name in wanted:
        if f"/{name}" not in store.enclaves():
            _print_created(store.issue(name))


@_both_spellings("create_permission", hidden=True)
def create_permission(root: Root, name: Name, policy: Policy) -> None:
    """Say that there are no permission files."""
    raise no_policies_error("create_permission")


@_both_spellings("generate_policy", hidden=True)
def generate_policy(policy: Policy) -> None:
    """Say that there are no permission files."""
    raise no_policies_error("generate_policy")
