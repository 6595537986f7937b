"""Readers of what hubs and members of a class send, and of the files of a class."""

from __future__ import annotations

import json
import os
from dataclasses import asdict
from typing import Any

import zenoh

from tests.torture.reader import FOLDER, Reader, file_with, json_bytes, text_of
from zbot.classroom.bundle import manifest
from zbot.classroom.bundle.errors import BundleError
from zbot.classroom.errors import ClassValueError
from zbot.classroom.hub.address import Address, parse_address
from zbot.classroom.hub.queries import document_of
from zbot.classroom.join_code import decode
from zbot.classroom.student.lobby import membership_from
from zbot.classroom.teacher import class_record
from zbot.classroom.teacher.class_record import ClassRecord, load_record
from zbot.classroom.teacher.expectation import parse_expectations
from zbot.classroom.teacher.join_service import JoinService
from zbot.classroom.teacher.laptops import Laptops
from zbot.classroom.teacher.robots import driver_in
from zbot.classroom.teacher.roster import read_roster
from zbot.classroom.teacher.student_list import StudentList
from zbot.log.teacher_notice import notice_text
from zbot.security.certificate import facts
from zbot.security.errors import SecurityError
from zbot.security.pin import PinClient, PinError, PinServer
from zbot.security.secret import Secret
from zbot.text.json_reader import JsonError, read_json_object
from zbot.transport import membership
from zbot.transport.membership import Membership, MembershipError

_ADDRESS = Address("10.0.0.1", 7447)


def _pin(data: bytes) -> None:
    document = read_json_object(data)
    server, client = _PIN_SERVER, PinClient(Secret("1"), "4b", "hub")
    for step in (
        lambda: server.challenge(document),
        lambda: server.admit(document),
        lambda: client.claim(document, {}),
        lambda: client.opened(document),
    ):
        try:
            step()
        except PinError as error:
            assert str(error)  # noqa: PT017 - each step has the same named error


_PIN_SERVER = PinServer(Secret("1"), "4b", bool, lambda: 0.0, lambda _: None)
_PIN_SERVER._guesses = 1e9


def _join_service(data: bytes) -> None:
    service = JoinService(
        "4b",
        "",
        StudentList("ab"),
        is_own_hub=bool,
        credentials=lambda _: {},
        changed=lambda _: None,
    )
    json.dumps(service.answer(document_of(zenoh.ZBytes(data))))


def _laptop_facts(data: bytes) -> None:
    students = StudentList("ab")
    Laptops(students)._learn(5, document_of(zenoh.ZBytes(data)), 0, 1)
    json.dumps(students.laptop(5).last_error)


def _saved(name: str, load: Any) -> Any:
    def call(data: bytes) -> None:
        before = os.environ.get("XDG_CONFIG_HOME")
        os.environ["XDG_CONFIG_HOME"] = str(FOLDER)
        try:
            membership.folder().mkdir(exist_ok=True)
            (membership.folder() / name).write_bytes(data)
            load()
        finally:
            os.environ.pop("XDG_CONFIG_HOME")
            if before is not None:
                os.environ["XDG_CONFIG_HOME"] = before

    return call


def _record() -> bytes:
    return json_bytes(ClassRecord("4b", StudentList("ab")).document())


def _membership() -> bytes:
    return json_bytes(asdict(Membership("student", "10.0.0.1", 7447, number=5)))


_HELLO = PinClient(Secret("1"), "4b", "hub")
_CHALLENGE = _PIN_SERVER.challenge(_HELLO.hello())

CLASS_READERS = (
    Reader(
        "robot_driver",
        ("zbot.classroom.teacher.robots",),
        lambda data: driver_in(document_of(zenoh.ZBytes(data)), "robot"),
        (),
        (b'{"drivers": {"robot": 17}}', b'{"drivers": {"robot": true}}', b'{"drivers": [17]}'),
    ),
    Reader(
        "teacher_notice",
        ("zbot.log.teacher_notice",),
        notice_text,
        (),
        (b'{"text": "hello", "time": 5}',),
    ),
    Reader(
        "hub_document",
        ("zbot.classroom.hub.queries",),
        lambda data: document_of(zenoh.ZBytes(data)),
        (),
        (b'{"op": "hello"}', b"[" * 9000),
    ),
    Reader(
        "join_service",
        ("zbot.classroom.teacher.join_service",),
        _join_service,
        (),
        (
            b'{"op": "hello"}',
            json_bytes({"op": "enrol", **_HELLO.hello()}),
            b'{"op": "release", "number": 5, "proof": "\xc3\xa9"}',
        ),
    ),
    Reader(
        "laptop_facts",
        ("zbot.classroom.teacher.laptops",),
        _laptop_facts,
        (),
        (
            json_bytes(
                {
                    "version": "1",
                    "system": "Linux",
                    "time_ns": 5,
                    "last_error": {"node": "a", "text": "b"},
                }
            ),
        ),
    ),
    Reader(
        "class_membership",
        ("zbot.classroom.student.lobby",),
        lambda data: membership_from(_ADDRESS, document_of(zenoh.ZBytes(data))),
        (KeyError, TypeError, ValueError),
        (
            json_bytes(
                {
                    "class": "4b",
                    "number": 17,
                    "name": "Ana",
                    "claim": "a1",
                    "hub_id": "f0",
                    "user": "student17",
                    "secret": "ab",
                }
            ),
        ),
    ),
    Reader(
        "pin",
        ("zbot.security.pin",),
        _pin,
        (JsonError,),
        (
            json_bytes(_HELLO.hello()),
            json_bytes(_CHALLENGE),
            json_bytes(_HELLO.claim(_CHALLENGE, {"a": 1})),
            json_bytes(
                {"answer": "00", "tag": "00", "visit": "\ud800", "claim": "00", "proof": "a"}
            ),
        ),
        limit_s=2.0,
    ),
    Reader(
        "join_code",
        ("zbot.classroom.join_code",),
        lambda data: decode(text_of(data), ["10.0.0.5"]),
        (ClassValueError,),
        (b"0A1B", b"0A1B-2C3D", b"oil1"),
    ),
    Reader(
        "hub_address",
        ("zbot.classroom.hub.address",),
        lambda data: parse_address(text_of(data)),
        (ClassValueError,),
        (b"192.168.1.10:7447", b"[fe80::1]:7447", b"teacher.local"),
    ),
    Reader(
        "expectation",
        ("zbot.classroom.teacher.expectation",),
        lambda data: parse_expectations(text_of(data)),
        (ClassValueError,),
        (
            b"publishes std_msgs/String on /a at >= 1.5 Hz and runs /b",
            b"serves example_interfaces/AddTwoInts on add; subscribes std_msgs/msg/String on b",
        ),
    ),
    Reader(
        "roster",
        ("zbot.classroom.teacher.roster",),
        lambda data: read_roster(text_of(data)),
        (ClassValueError,),
        (b'number,name\n1,Ana\n2,"B"\n', b"5;Eve\n"),
    ),
    Reader(
        "membership_file",
        ("zbot.transport.membership",),
        _saved(membership.FILE, membership.load),
        (MembershipError,),
        (_membership(), b"[]"),
    ),
    Reader(
        "class_file",
        ("zbot.classroom.teacher.class_record",),
        _saved(class_record.record_path().name, load_record),
        (ClassValueError,),
        (_record(), b"{}"),
    ),
    Reader(
        "bundle",
        ("zbot.classroom.bundle.manifest",),
        lambda data: manifest.load(file_with(manifest.FILE, data).parent),
        (BundleError,),
        (
            json_bytes(
                {
                    "zbot": "0.1.0",
                    "extras": ["web"],
                    "targets": {"linux-x86_64-3.13": {"extras": ["web"], "wheels": ["a.whl"]}},
                    "files": {"wheels/a.whl": "ab"},
                }
            ),
        ),
    ),
    Reader(
        "certificate",
        ("zbot.security.certificate",),
        lambda data: facts(file_with("cert.pem", data)),
        (SecurityError,),
        (b"-----BEGIN CERTIFICATE-----\nMIIB\n-----END CERTIFICATE-----\n",),
    ),
)
