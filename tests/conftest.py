"""Fixtures of all tests: a domain of their own, a clean environment, and ended processes."""

from __future__ import annotations

import gc
import itertools
import os
import signal
import sys
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING

import hypothesis
import pytest

import zbot
import zbot.testing
from zbot.log.registry import REGISTRY
from zbot.testing.domain import open_router, reserved_domain
from zbot.transport.rmw_choice import RMW_VARIABLE, RMW_ZENOH

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator

    from tests.docs.machines import Machines
    from zbot.log.record import Record

    MakeContext = Callable[[], zbot.Context]
    Spin = Callable[..., "Spinner"]
    Start = Callable[..., "Program"]

# No deadline: other tests use the machine at the same time and slow examples down. Each run has the
# same examples: a test does not fail by chance. `--hypothesis-profile=random` looks for others.
for name, is_same in (("random", False), ("zbot", True)):
    hypothesis.settings.register_profile(
        name,
        hypothesis.settings(),
        deadline=None,
        derandomize=is_same,
        suppress_health_check=[hypothesis.HealthCheck.too_slow],
    )
hypothesis.settings.load_profile("zbot")

# A shell starts a program with `&` so that it ignores Ctrl-C, and its children too. Tests send it.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Bytecode is kept: otherwise every worker and every program would compile everything again.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

# Programs that tests start import the same zbot as the tests: that of the checkout.
_ROOT = Path(__file__).parents[1]
os.environ["PYTHONPATH"] = os.pathsep.join(str(_ROOT / folder) for folder in ("", "cli", "nodes"))

_test_numbers = itertools.count()
#: Whose rclpy the tests use in a Python that also has a genuine one.
_RCLPY = os.environ.get("ZBOT_RCLPY", "")
_PREFIXES = ("ZBOT_", "ROS_", "RCUTILS_", "RMW_", "ZENOH_", "AMENT_", "COLCON_")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--rmw", action="store_true", help="run the tests in ROS 2's dialect, rmw_zenoh_cpp"
    )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not config.getoption("--rmw"):
        return
    for item in items:
        for mark in item.iter_markers("own_dialect"):
            item.add_marker(pytest.mark.skip(reason=mark.args[0]))


def speaks_ros2() -> bool:
    """Return whether the tests run in ROS 2's dialect."""
    return os.environ.get(RMW_VARIABLE) == RMW_ZENOH


@pytest.fixture(autouse=True)
def clean_environment(
    monkeypatch: pytest.MonkeyPatch,
    tmp_path_factory: pytest.TempPathFactory,
    pytestconfig: pytest.Config,
) -> None:
    for name in list(os.environ):
        if name.startswith(_PREFIXES) and name != "ZBOT_ROS2_PREFIX":
            monkeypatch.delenv(name)
    if _RCLPY:
        monkeypatch.setenv("ZBOT_RCLPY", _RCLPY)
    monkeypatch.setattr("zbot.package.import_finder._prefers_zbot", _RCLPY == "zbot")
    if pytestconfig.getoption("--rmw"):
        monkeypatch.setenv(RMW_VARIABLE, RMW_ZENOH)
    monkeypatch.setenv("ZBOT_NO_BROWSER", "1")  # open no pages on this desktop
    # The machine may have joined a class and run a hub: tests must not connect to it.
    settings = tmp_path_factory.getbasetemp() / f"no_settings_{next(_test_numbers)}"
    monkeypatch.setenv("XDG_CONFIG_HOME", str(settings))
    monkeypatch.setenv("ZBOT_HUB_PORT", "9")  # "discard": an unused port
    # A context of a test gets the answers of others also if the whole suite keeps the machine busy.
    monkeypatch.setattr("zbot.context.domain_session._PEERS_TIMEOUT_S", 2.0)
    monkeypatch.setattr("zbot.context.domain_session._DISCOVERY_TIMEOUT_S", 5.0)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect the tests without the garbage collector, which then never looks at them again."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """Return the number of workers of `-n auto`: tests wait for processes half of the time."""
    return 2 * (os.cpu_count() or 1)


@pytest.fixture
def free_domain(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """Return an unused domain of this machine, and put it into the environment."""
    with reserved_domain() as reserved:
        monkeypatch.setenv("ZBOT_DOMAIN_ID", str(reserved))
        yield reserved


@pytest.fixture
def domain(free_domain: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """Return an unused domain whose router runs in this process, which is faster."""
    router = open_router(free_domain, monkeypatch)
    assert router is not None
    yield free_domain
    router.close()


def allowed(limit_s: float) -> float:
    """Return a time limit in seconds for the present load; `limit_s` is that of an idle machine.

    A load of three times the number of processors allows three times as long.
    """
    workers = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0  # Windows has none
    return limit_s * max(1.0, max(workers, load) / (os.cpu_count() or 1))


def wait_until(condition: Callable[[], bool], timeout_s: float = 15.0) -> bool:
    """Wait until a condition holds; return whether it did within `allowed(timeout_s)`.

    The default is long enough for the start of a process: it only matters where a test fails.
    """
    begun = time.monotonic()
    pause = threading.Event()
    while True:
        looked = time.monotonic()
        if condition():
            return True
        now = time.monotonic()
        if now - begun > allowed(timeout_s):  # the load may have risen meanwhile
            return False
        # A look may be a process. One after the other would slow down what they wait for.
        pause.wait(min(max(now - looked, 0.005), 0.5))


def in_threads(work: Callable[[int], object], count: int) -> None:
    """Call a function with each number below `count`, in threads of their own, and wait for all."""
    threads = [threading.Thread(target=work, args=(number,)) for number in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


@pytest.fixture
def make_context(domain: int) -> Iterator[Callable[[], zbot.Context]]:
    """Return a function that makes initialised contexts in the test's domain."""
    made: list[zbot.Context] = []

    def make() -> zbot.Context:
        context = zbot.Context()
        context.init([], domain_id=domain)
        made.append(context)
        return context

    yield make
    for context in made:
        context.shutdown()


class Spinner:
    """Thread that spins nodes of one context until the test ends."""

    def __init__(self, *nodes: zbot.Node, executor: zbot.Executor | None = None) -> None:
        self.executor = executor or zbot.SingleThreadedExecutor(context=nodes[0].context)
        for node in nodes:
            self.executor.add_node(node)
        self.error: BaseException | None = None
        self._thread = threading.Thread(target=self._spin)
        self._thread.start()

    def _spin(self) -> None:
        try:
            self.executor.spin()
        except zbot.ExternalShutdownException:
            return
        except BaseException as exc:  # noqa: BLE001 - the test checks it
            self.error = exc

    def stop(self) -> None:
        self.executor.shutdown(15)
        self._thread.join(15)
        assert not self._thread.is_alive()

    def join(self, timeout_s: float = 5.0) -> None:
        self._thread.join(timeout_s)


@pytest.fixture
def logged() -> Iterator[list[Record]]:
    """Return a list that fills with every log line of this process."""
    records: list[Record] = []
    REGISTRY.add_sink("", records.append)
    yield records
    REGISTRY.remove_sink("", records.append)


@pytest.fixture
def spin(make_context: object) -> Iterator[Callable[..., Spinner]]:  # noqa: ARG001 - ends before it
    """Return a function that spins nodes in a thread."""
    running: list[Spinner] = []

    def start(*nodes: zbot.Node, executor: zbot.Executor | None = None) -> Spinner:
        running.append(Spinner(*nodes, executor=executor))
        return running[-1]

    yield start
    for spinner in running:
        spinner.stop()


class Program(zbot.testing.Program):
    """Program of a test, with more time if other tests keep the machine busy."""

    def wait_for(self, text: str, timeout: float = 20.0) -> str:
        __tracebackhide__ = True
        return super().wait_for(text, allowed(timeout))

    def wait(self, timeout: float = 30.0) -> int:
        return super().wait(allowed(timeout))

    def wait_for_rate(self, rate_hz: float, within_hz: float) -> None:
        """Wait for a rate reported by `topic hz`; the first ones may be low on a busy machine."""
        rates = [float(self.wait_for("average rate: ").rpartition(" ")[2])]
        while abs(rates[-1] - rate_hz) > within_hz:
            assert len(rates) < 10, rates
            rates.append(float(self.wait_for("average rate: ").rpartition(" ")[2]))


@pytest.fixture
def start(domain: int, tmp_path: Path) -> Iterator[Callable[..., Program]]:  # noqa: ARG001 - by $
    """Return a function that starts a program: Python source or the words of a command.

    Python runs the source, or `zbot run` if `by_zbot` is true.
    """
    running: list[Program] = []
    counter = iter(range(1000))

    def run(
        *words: str,
        source: str | None = None,
        env: dict[str, str] | None = None,
        by_zbot: bool = False,
    ) -> Program:
        command = list(words)
        if source is not None:
            path = tmp_path / f"program_{next(counter)}.py"
            path.write_text(source, encoding="utf-8")
            runner = ["-m", "zbot_cli", "run"] if by_zbot else []
            command = ["python", "-u", *runner, str(path), *words]
        elif command[0] == "zbot":
            command = ["python", "-m", "zbot_cli", *command[1:]]
        program = Program(command, tmp_path, {**os.environ, **(env or {})})
        running.append(program)
        return program

    yield run
    for program in running:
        if program.process.poll() is None:
            program.process.kill()
        program.process.wait(5)


@pytest.fixture
def machines(domain: int, tmp_path: Path) -> Iterator[Machines]:
    """Return the machines of a page of the documentation. They are switched off at the end."""
    from tests.docs.machines import Machines  # noqa: PLC0415 - most tests do not need it

    assert domain
    with reserved_domain() as first, reserved_domain() as second:
        made = Machines(tmp_path, sorted([first, second]))
        yield made
        made.switch_off()
