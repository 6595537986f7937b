"""Plugin of pytest with the fixtures for tests of nodes.

pytest imports this module at each start, also for tests that do not use zbot. So it imports nothing
of zbot before a test uses a fixture.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from zbot.executor.executor import Executor
    from zbot.testing.fixtures import Call, NodeFactory, Received, SpinUntil, Start
    from zbot.testing.program import Program

_PROGRAMS = pytest.StashKey["list[Program]"]()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Iterator[None]:
    """Add the output of the test's programs to the report of a test that failed."""
    report: pytest.TestReport = yield  # type: ignore[assignment]
    if report.failed:
        for program in item.stash.get(_PROGRAMS, ()):
            report.sections.append((f"output of {program}", program.output))
    return report  # type: ignore[return-value]


@pytest.fixture
def domain_id(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[int]:
    """Return a domain that no other test and no other program of this machine uses.

    The programs that the test starts are in this domain too.
    """
    from zbot.testing.domain import isolate, open_router, reserved_domain  # noqa: PLC0415 - as above

    with reserved_domain() as domain:
        isolate(monkeypatch, domain, tmp_path)
        router = open_router(domain, monkeypatch)
        yield domain
        if router is not None:
            router.close()


@pytest.fixture
def executor(domain_id: int) -> Iterator[Executor]:
    """Return the executor of the test's nodes. A test file may replace it by its own fixture.

    `zbot.init()` runs before the test, and `zbot.shutdown()` after it.
    """
    import zbot  # noqa: PLC0415 - as above

    zbot.init(args=[], domain_id=domain_id, signal_handler_options=zbot.SignalHandlerOptions.NO)
    executor = zbot.SingleThreadedExecutor()
    yield executor
    executor.shutdown(0)
    zbot.try_shutdown()


@pytest.fixture
def node(executor: Executor) -> Iterator[NodeFactory]:
    """Return a function that makes nodes. The nodes are destroyed after the test."""
    from zbot.testing.fixtures import NodeFactory  # noqa: PLC0415 - as above

    factory = NodeFactory(executor)
    yield factory
    factory.destroy()


@pytest.fixture
def spin_until(executor: Executor, request: pytest.FixtureRequest) -> SpinUntil:
    """Return a function that spins the test's nodes until a condition is true."""
    from zbot.testing.fixtures import SpinUntil  # noqa: PLC0415 - as above

    return SpinUntil(executor, _programs(request))


@pytest.fixture
def received(spin_until: SpinUntil, node: NodeFactory) -> Received:
    """Return a function that waits for messages of a topic and returns them."""
    from zbot.testing.fixtures import Received  # noqa: PLC0415 - as above

    return Received(spin_until, node)


@pytest.fixture
def call(spin_until: SpinUntil, node: NodeFactory) -> Call:
    """Return a function that calls a service and returns the response."""
    from zbot.testing.fixtures import Call  # noqa: PLC0415 - as above

    return Call(spin_until, node)


@pytest.fixture
def start(domain_id: int, request: pytest.FixtureRequest) -> Iterator[Start]:  # noqa: ARG001 - by the environment
    """Return a function that starts a program. The program is ended after the test."""
    from zbot.testing.fixtures import Start  # noqa: PLC0415 - as above

    programs = _programs(request)
    yield Start(programs)
    for program in programs:
        program.end()


def _programs(request: pytest.FixtureRequest) -> list[Program]:
    programs: list[Program] = request.node.stash.setdefault(_PROGRAMS, [])
    return programs
