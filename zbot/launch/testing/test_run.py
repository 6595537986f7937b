"""Run of a launch test: the launch and the test cases of one test file."""

from __future__ import annotations

import functools
import importlib.util
import inspect
import sys
import unittest
from typing import TYPE_CHECKING, Any

from zbot.launch.actions.event_action import RegisterEventHandler
from zbot.launch.description import LaunchDescription
from zbot.launch.testing.error import LaunchTestError
from zbot.launch.testing.marker import markers_of
from zbot.launch.testing.running_launch import (
    READY_TIMEOUT_S,
    RunningLaunch,
    on_ready_to_test,
    ready_actions,
)
from zbot.package.absent import absent_packages_reported

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence
    from pathlib import Path
    from types import ModuleType

_FUNCTION = "generate_test_description"
_FIXTURES = ("setUpClass", "tearDownClass", "setUp", "tearDown")


def load_module(path: Path) -> ModuleType:
    """Import a test file.

    Raises:
        LaunchTestError: The file is not a Python file, or it does not describe a launch.
    """
    spec = importlib.util.spec_from_file_location(path.stem.replace(".", "_"), path)
    if spec is None or spec.loader is None:
        raise LaunchTestError(f"{path} is not a Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # pickle and dataclasses look modules up there
    spec.loader.exec_module(module)
    if not callable(getattr(module, _FUNCTION, None)):
        raise LaunchTestError(f"{path} has no function {_FUNCTION}()")
    return module


def test_runs(module: ModuleType) -> list[TestRun]:
    """Return one run for each set of values of `parametrize`. Return one run if it is not used."""
    function = getattr(module, _FUNCTION)
    return [TestRun(module, row) for row in markers_of(function).get("rows", [{}])]


class TestRun:
    """One launch and its tests.

    Args:
        module: The test file.
        parameters: The values of `parametrize`, which the description and the tests get.
    """

    __test__ = False  # not a test class of pytest

    def __init__(self, module: ModuleType, parameters: Mapping[str, Any]) -> None:
        self._module = module
        self._parameters = dict(parameters)
        self._function = getattr(module, _FUNCTION)

    @property
    def name(self) -> str:
        """The parameters as pytest writes them, e.g. `[1-fast]`, or an empty text without them."""
        values = "-".join(map(str, self._parameters.values()))
        return f"[{values}]" if values else ""

    def run(
        self,
        arguments: Mapping[str, str] | None = None,
        *,
        verbosity: int = 2,
        debug: bool = False,
    ) -> list[unittest.TestResult]:
        """Start the launch, run the tests, end the launch, and run the post-shutdown tests.

        Args:
            arguments: Launch arguments, which tests get as `test_args`.
            verbosity: The same as in unittest, where 2 writes a line for each test.
            debug: Whether debug lines of the launch are shown.

        Returns:
            The results of the tests during the launch and of the tests after the launch.

        Raises:
            LaunchTestError: The description is invalid, or the launch ended before its tests.
        """
        try:
            description, given = self._describe()
        except unittest.SkipTest as skip:
            return [self._skipped(str(skip))]
        markers = markers_of(self._function)
        keep_alive = bool(markers.get("keep_alive"))
        launch = RunningLaunch(description, arguments, keep_alive=keep_alive, debug=debug)
        attributes = {
            **given,
            **self._parameters,
            "proc_info": launch.proc_info,
            "proc_output": launch.proc_output,
            "launch_service": launch.service,
            "test_args": dict(arguments or {}),
        }
        try:
            launch.wait_until_ready(markers.get("ready_timeout", READY_TIMEOUT_S))
            active = self._run_cases(attributes, verbosity, after=False)
            if launch.is_over:
                raise LaunchTestError(
                    "the processes under test ended before their tests did",
                    "@launch_testing.markers.keep_alive keeps the launch going",
                )
        finally:
            launch.stop()
        return [active, self._run_cases(attributes, verbosity, after=True)]

    def validate(self) -> None:
        """Check that `generate_test_description` has the same arguments as `parametrize`.

        Raises:
            LaunchTestError: The arguments differ.
        """
        taken = inspect.signature(self._function).parameters
        for name in self._parameters:
            if name not in taken:
                raise LaunchTestError(f"Could not find an argument of {_FUNCTION}() for '{name}'")
        for name, parameter in taken.items():
            if name not in self._parameters and parameter.default is parameter.empty:
                raise LaunchTestError(f"{_FUNCTION}() has an unexpected extra argument '{name}'")

    def normalized_test_description(
        self, *, ready_fn: Callable[[], object]
    ) -> tuple[LaunchDescription, dict[str, Any]]:
        """Return the description and the extra arguments for its tests.

        Args:
            ready_fn: Called when the launch reaches `ReadyToTest`.

        Raises:
            LaunchTestError: The description has no `ReadyToTest`.
        """
        description, given = self._describe()
        if not any(ready_actions(description.entities)):
            what = "a LaunchDescription containing a ReadyToTest action"
            raise LaunchTestError(f"{_FUNCTION}() must return {what}")
        description.add_action(RegisterEventHandler(on_ready_to_test(ready_fn)))
        return description, given

    def _skipped(self, reason: str) -> unittest.TestResult:
        result = unittest.TestResult()
        for case in (*self._cases(after=False), *self._cases(after=True)):
            for name in unittest.defaultTestLoader.getTestCaseNames(case):
                test = case(name)
                result.startTest(test)
                result.addSkip(test, reason)
                result.stopTest(test)
        return result

    def _describe(self) -> tuple[LaunchDescription, dict[str, Any]]:
        with absent_packages_reported():  # the launch says what it leaves out
            returned = self._function(**self._parameters)
        pair = returned if isinstance(returned, tuple) else (returned, {})
        if len(pair) != 2 or not isinstance(pair[0], LaunchDescription):
            what = "a LaunchDescription, alone or in a pair with a dict of arguments for the tests"
            raise LaunchTestError(f"{_FUNCTION}() must return {what}, not {returned!r}")
        return pair

    def _run_cases(
        self, attributes: dict[str, Any], verbosity: int, *, after: bool
    ) -> unittest.TestResult:
        suite = unittest.TestSuite()
        for case in self._cases(after=after):
            names = unittest.defaultTestLoader.getTestCaseNames(case)
            bound = _bound(case, names, attributes)
            suite.addTests(map(bound, names))
        return unittest.TextTestRunner(verbosity=verbosity).run(suite)

    def _cases(self, *, after: bool) -> Iterator[type[unittest.TestCase]]:
        for member in vars(self._module).values():
            is_case = isinstance(member, type) and issubclass(member, unittest.TestCase)
            if is_case and getattr(member, "__post_shutdown_test__", False) is after:
                yield member


def _bound(
    case: type[unittest.TestCase], names: Sequence[str], attributes: dict[str, Any]
) -> type[unittest.TestCase]:
    """Return a subclass of a test case. Its methods get their arguments from `attributes`."""
    members: dict[str, Any] = {
        name: value for name, value in attributes.items() if not hasattr(case, name)
    }
    for name in (*_FIXTURES, *names):
        function = inspect.getattr_static(case, name)
        is_of_class = isinstance(function, classmethod)
        plain = function.__func__ if is_of_class else function
        wanted = {
            key: attributes[key] for key in inspect.signature(plain).parameters if key in attributes
        }
        if wanted:
            filled = _filled(plain, wanted)
            members[name] = classmethod(filled) if is_of_class else filled
    return type(case.__name__, (case,), {**members, "__module__": case.__module__})


def _filled(function: Any, wanted: dict[str, Any]) -> Any:
    @functools.wraps(function)
    def filled(self: Any) -> Any:
        return function(self, **wanted)

    return filled
