"""Tests of `zbot security`: messages of ros2, and certificates that other tools accept."""

from __future__ import annotations

import json
import os
import shutil
import stat
import subprocess
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot

if TYPE_CHECKING:
    from pathlib import Path


def security(folder: Path, *words: str) -> str:
    done = zbot("security", *words, cwd=folder)
    assert (done.code, done.err) == (0, ""), done
    return done.out


def refused(folder: Path, *words: str) -> str:
    done = zbot("security", *words, cwd=folder)
    assert (done.code, done.out) == (1, ""), done
    return done.err


def test_the_commands_of_ros2s_tutorial_work(tmp_path: Path) -> None:
    security(tmp_path, "create_keystore", "demo_keystore")
    security(tmp_path, "create_enclave", "demo_keystore", "/talker_listener/talker")
    security(tmp_path, "create_enclave", "demo_keystore", "/talker_listener/listener")
    listed = security(tmp_path, "list_enclaves", "demo_keystore")
    assert listed == "/talker_listener/listener\n/talker_listener/talker\n"


def test_the_verbs_may_be_written_with_dashes(tmp_path: Path) -> None:
    security(tmp_path, "create-keystore", "keys")
    out = security(tmp_path, "create-certificate", "keys", "teacher", "--ip", "10.0.0.5")
    assert "created keys/enclaves/teacher: /teacher, valid until" in out.replace(os.sep, "/")
    assert "10.0.0.5" in out
    assert json.loads(security(tmp_path, "list-enclaves", "keys", "--json")) == ["/teacher"]


def test_generate_artifacts_makes_only_missing_files(tmp_path: Path) -> None:
    security(tmp_path, "generate_artifacts", "-k", "keys", "-e", "/a", "/b/c")
    before = (tmp_path / "keys/enclaves/a/key.pem").read_bytes()
    security(tmp_path, "generate_artifacts", "-k", "keys", "-e", "/a", "-e", "/d")
    assert security(tmp_path, "list_enclaves", "keys") == "/a\n/b/c\n/d\n"
    assert (tmp_path / "keys/enclaves/a/key.pem").read_bytes() == before


def test_generate_artifacts_finds_the_keystore_as_ros2_does(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "ROS_SECURITY_KEYSTORE" in refused(tmp_path, "generate_artifacts", "-e", "/a")
    monkeypatch.setenv("ROS_SECURITY_KEYSTORE", str(tmp_path / "keys"))
    security(tmp_path, "generate_artifacts", "-e", "/a")
    assert security(tmp_path, "list_enclaves", "keys") == "/a\n"


def test_mistakes_are_refused_in_ros2s_words(tmp_path: Path) -> None:
    security(tmp_path, "create_keystore", "keys")
    error = refused(tmp_path, "create_keystore", "keys")
    assert error == "Unable to create keystore: keystore 'keys' already exists\n"
    assert "'nowhere' is not a valid keystore" in refused(
        tmp_path, "create_enclave", "nowhere", "/a"
    )
    assert "is not a valid enclave name" in refused(tmp_path, "create_enclave", "keys", "../a")
    assert "neither a host name" in refused(
        tmp_path, "create_enclave", "keys", "/a", "--ip", "1.2.3.4/5"
    )
    assert "no permission files" in refused(tmp_path, "generate_policy", "policy.xml")
    assert "no permission files" in refused(tmp_path, "create_permission", "keys", "/a", "p.xml")


def test_a_certificate_is_shown_and_checked(tmp_path: Path) -> None:
    security(tmp_path, "create_keystore", "keys")
    security(tmp_path, "create_enclave", "keys", "/ana", "--days", "30")
    shown = json.loads(security(tmp_path, "check_certificate", "keys/enclaves/ana", "--json"))
    assert (shown["name"], shown["addresses"], shown["is_server"]) == ("ana", [], False)
    assert "it joins others" in security(tmp_path, "check_certificate", "keys")
    (tmp_path / "keys/enclaves/ana/key.pem").unlink()
    assert "there is no key at" in refused(tmp_path, "check_certificate", "keys")


@pytest.mark.skipif(os.name == "nt", reason="Windows has no file modes")
def test_files_are_readable_by_their_owner_only_for_any_umask(tmp_path: Path) -> None:
    before = os.umask(0)
    try:
        security(tmp_path, "generate_artifacts", "-k", "keys", "-e", "/a")
    finally:
        os.umask(before)
    modes = {stat.S_IMODE(path.stat().st_mode) for path in (tmp_path / "keys").rglob("*.pem")}
    assert modes == {0o600}
    assert stat.S_IMODE((tmp_path / "keys").stat().st_mode) == 0o700


@pytest.mark.skipif(shutil.which("openssl") is None, reason="openssl is not installed")
def test_openssl_accepts_the_certificates(tmp_path: Path) -> None:
    security(tmp_path, "create_keystore", "keys")
    security(tmp_path, "create_enclave", "keys", "/ana")
    security(
        tmp_path, "create_enclave", "keys", "/teacher", "--ip", "10.0.0.5", "--host", "t.local"
    )
    enclaves = tmp_path / "keys" / "enclaves"

    def verify(name: str, *words: str) -> bool:
        folder = enclaves / name
        files = ["-CAfile", str(folder / "ca.cert.pem"), *words, str(folder / "cert.pem")]
        done = subprocess.run(
            ["openssl", "verify", "-x509_strict", *files], capture_output=True, check=False
        )
        return done.returncode == 0

    assert verify("ana", "-purpose", "sslclient")
    assert not verify("ana", "-purpose", "sslserver")
    assert verify("teacher", "-purpose", "sslserver", "-verify_ip", "10.0.0.5")
    assert verify("teacher", "-purpose", "sslclient", "-verify_hostname", "t.local")
    assert not verify("teacher", "-purpose", "sslserver", "-verify_ip", "10.0.0.6")
