"""Testbed: which machines reach each other, and that nothing remains when it ends."""

from __future__ import annotations

import socket
from typing import TYPE_CHECKING

from tests.classroom.impairment import Impairment, impair
from tests.classroom.network import namespaces

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.machine import Machine
    from tests.classroom.testbed import LanTestbed

SERVE = """
import socket
server = socket.create_server(("0.0.0.0", 7000))
print("serving", socket.gethostname(), flush=True)
while True:
    connection, _ = server.accept()
    connection.close()
"""
DIAL = """
import socket, sys
try:
    socket.create_connection((sys.argv[1], 7000), 3).close()
    print("reached")
except OSError as exc:
    print(type(exc).__name__)
"""
SHOUT = """
import socket
sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for _ in range(3):
    sender.sendto(b"anybody?", ("224.0.0.224", 7446))
"""
HEAR = """
import socket, struct
receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
receiver.bind(("224.0.0.224", 7446))
group = struct.pack("4s4s", socket.inet_aton("224.0.0.224"), socket.inet_aton("0.0.0.0"))
receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, group)
receiver.settimeout(0.5)
print("listening", flush=True)
try:
    receiver.recv(100)
    print("heard", flush=True)
except TimeoutError:
    print("silence", flush=True)
"""


def serve(machine: Machine) -> str:
    return machine.start("python", "-c", SERVE).wait_for("serving").split()[1]


def dial(machine: Machine, other: Machine) -> str:
    return machine.run("python", "-c", DIAL, other.address).out.strip()


def test_laptops_reach_the_teacher_but_not_each_other(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(2)
    one, two = testbed.laptops

    hosts = [serve(testbed.teacher), serve(two)]

    assert hosts == ["teacher", "laptop1"]
    assert hosts[0] != socket.gethostname()
    assert dial(one, testbed.teacher) == "reached"
    assert dial(one, two) in {"TimeoutError", "OSError"}  # no answer even to ARP
    assert dial(testbed.teacher, two) == "reached"


def test_multicast_does_not_pass(make_testbed: Callable[[int], LanTestbed]) -> None:
    testbed = make_testbed(1)
    listener = testbed.teacher.start("python", "-c", HEAR)
    listener.wait_for("listening")

    testbed.laptops[0].run("python", "-c", SHOUT)

    listener.wait_for("silence")


def test_traffic_is_counted(make_testbed: Callable[[int], LanTestbed]) -> None:
    testbed = make_testbed(1)
    serve(testbed.teacher)
    before = testbed.teacher.traffic()

    dial(testbed.laptops[0], testbed.teacher)

    carried = testbed.teacher.traffic() - before
    assert carried.received_packets >= 3
    assert carried.sent_bytes > 0


def test_the_testbed_removes_everything(make_testbed: Callable[[int], LanTestbed]) -> None:
    testbed = make_testbed(1)
    laptop = testbed.laptops[0]
    background = laptop.start("python", "-c", "import time; print('there'); time.sleep(600)")
    background.wait_for("there")
    names = {machine.namespace for machine in testbed.machines}
    assert names <= set(namespaces())

    testbed.__exit__()

    assert background.process.poll() is not None
    assert not names & set(namespaces())
    assert not laptop.home.exists()


def test_without_a_class_nothing_leaves_the_laptop(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(1)
    laptop = testbed.laptops[0]
    testbed.teacher.start("plain_hub.py", "tcp/0.0.0.0:7447").wait_for("hub")
    before = laptop.traffic()

    laptop.start("zbot", "run", "sensor").wait_for("Temperature:")

    assert laptop.run("zbot", "node", "list").out == "/temperature_sensor\n"
    assert testbed.teacher.run("zbot", "node", "list").out == ""
    assert (laptop.traffic() - before).sent_bytes == 0


ROUND_TRIPS = """
import socket, sys, time
with socket.create_connection((sys.argv[1], 7001), 5) as connection:
    for _ in range(20):
        begun = time.monotonic()
        connection.sendall(b"x" * 3000)
        got = 0
        while got < 3000:
            got += len(connection.recv(5000))
        print(time.monotonic() - begun)
"""
ECHO = """
import socket
server = socket.create_server(("0.0.0.0", 7001))
print("serving", flush=True)
connection, _ = server.accept()
while data := connection.recv(5000):
    connection.sendall(data)
"""


def test_bad_wifi_delays_everything_and_loses_nothing_of_tcp(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(2)
    impair(testbed, Impairment(delay_ms=20, jitter_ms=10, loss=0.02), testbed.laptops[:1])
    testbed.teacher.start("python", "-c", ECHO).wait_for("serving")

    trips = testbed.laptops[0].run("python", "-c", ROUND_TRIPS, testbed.teacher.address).out.split()

    took = sorted(map(float, trips))
    assert len(took) == 20
    assert took[0] > 0.02
    assert 0.03 < took[10] < 0.3
    assert dial(testbed.laptops[0], testbed.laptops[1]) in {"TimeoutError", "OSError"}
