"""Changes of period, in the short form of `python -m tests.torture.periods`."""

from __future__ import annotations

from tests.classroom.conftest import skip_without_namespaces
from tests.classroom.testbed import LanTestbed
from tests.torture.periods import Periods
from tests.torture.report import Report


def test_students_leave_while_others_join() -> None:
    skip_without_namespaces()
    report = Report()
    with LanTestbed(6) as testbed:
        Periods(testbed, "a", 1.0, report).run(2)
    assert report.violations == []
