from __future__ import annotations

import errno
import struct
import sys
from typing import Any

import pytest

from zbot.bridge.devices.errors import DeviceError, DeviceSetupError
from zbot.bridge.devices.serial import port
from zbot.bridge.devices.serial.lost_bytes import lost_bytes
from zbot.bridge.devices.serial.port import NoPortError, PortHeldError, PortInfo

UNO = PortInfo("/dev/ttyACM0", "Arduino Uno", is_usb=True)
PICO = PortInfo("/dev/ttyACM1", "Pico", is_usb=True)
MODEM = PortInfo("/dev/ttyS0", "ttyS0", is_usb=False)


def test_the_only_board_on_usb_is_found() -> None:
    assert port.only_board([MODEM, UNO]) == UNO


def test_two_boards_are_named_with_what_to_type() -> None:
    with pytest.raises(DeviceError, match=r"there are 2 boards: .*Arduino Uno.*Pico") as caught:
        port.only_board([UNO, PICO])
    assert "zbot serial /dev/ttyACM0" in caught.value.hint


def test_without_a_board_the_cable_is_named() -> None:
    with pytest.raises(NoPortError, match=r"no board is on USB; other ports are /dev/ttyS0"):
        port.only_board([MODEM])
    with pytest.raises(NoPortError, match=r"no board is on USB$") as caught:
        port.only_board([])
    assert "cable" in caught.value.hint


def opening(monkeypatch: pytest.MonkeyPatch, error: Exception) -> None:
    def refuse(*_: object, **__: object) -> Any:
        raise error

    monkeypatch.setattr("serial.Serial", refuse)


@pytest.mark.skipif(sys.platform == "win32", reason="the numbers of errors are those of POSIX")
@pytest.mark.parametrize(
    ("number", "kind"),
    [
        (errno.EBUSY, PortHeldError),
        (errno.EWOULDBLOCK, PortHeldError),
        (errno.ENOENT, NoPortError),
        (errno.EACCES, DeviceSetupError),
        (errno.EINVAL, DeviceError),
    ],
)
def test_each_fault_of_a_port_has_its_error(
    monkeypatch: pytest.MonkeyPatch, number: int, kind: type[Exception]
) -> None:
    opening(monkeypatch, OSError(number, "x"))
    with pytest.raises(kind) as caught:
        port.open_port("/dev/ttyACM0", 9600)
    assert type(caught.value) is kind


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no groups for ports")
def test_a_missing_permission_says_what_to_type(monkeypatch: pytest.MonkeyPatch) -> None:
    opening(monkeypatch, PermissionError(errno.EACCES, "x"))
    monkeypatch.setenv("USER", "ana")
    with pytest.raises(DeviceSetupError, match=r"sudo usermod -a -G dialout ana.*log in again"):
        port.open_port("/dev/ttyACM77", 9600)


def test_a_wrong_baud_rate_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    opening(monkeypatch, ValueError("Invalid baud rate"))
    with pytest.raises(DeviceError, match="does not know the baud rate 7: try 115200"):
        port.open_port("/dev/ttyACM0", 7)


class Opened:
    """An open port that is not hardware."""

    def fileno(self) -> int:
        return 0


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only Linux counts lost bytes")
def test_bytes_that_the_system_has_lost_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    def count(_fd: int, _request: int, _empty: bytes) -> bytes:
        return struct.pack("20i", 0, 0, 0, 0, 900, 5, 1, 3, 0, 0, 4, *[0] * 9)

    def refuse(*_: object) -> bytes:
        raise OSError(errno.ENOTTY, "x")

    monkeypatch.setattr("fcntl.ioctl", count)
    assert lost_bytes(Opened()) == 7
    monkeypatch.setattr("fcntl.ioctl", refuse)
    assert lost_bytes(Opened()) == 0
