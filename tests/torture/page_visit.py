"""Window of a browser that stays open on the live page."""

from __future__ import annotations

import contextlib
import shutil
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tests.torture.report import Report

_PANELS = ("/topics?topic=/numbers", "/console")


class PageVisit:
    """Windows of a browser: one for each of some panels, all of which are visible.

    Args:
        browser: Playwright's browser.
        driver: Playwright itself.
        address: The address of the page.
        report: Takes the errors that the browser reports.
    """

    def __init__(self, browser: Any, driver: Any, address: str, report: Report) -> None:
        self._browser, self._driver, self._report = browser, driver, report
        self._pages = []
        for panel in _PANELS:
            page = browser.new_context().new_page()
            page.on("pageerror", lambda error: report.violation(f"the page reports: {error}"))
            page.goto(address + panel)
            self._pages.append(page)

    @classmethod
    def open(cls, address: str, report: Report) -> PageVisit | None:
        """Open the windows. Return None if there is no browser."""
        names = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
        path = next(filter(None, map(shutil.which, names)), None)
        try:
            from playwright.sync_api import sync_playwright  # noqa: PLC0415 - it may be missing
        except ImportError:
            report.note("no Playwright: the page is only loaded again and again")
            return None
        if path is None:
            report.note("no browser: the page is only loaded again and again")
            return None
        driver = sync_playwright().start()
        arguments = ["--no-sandbox", "--disable-gpu"]
        browser = driver.chromium.launch(executable_path=path, args=arguments)
        return cls(browser, driver, address, report)

    def memory(self) -> int:
        """Return the bytes that the scripts of all windows use."""
        used = 0
        for page in self._pages:
            with contextlib.suppress(Exception):
                used += page.evaluate("performance.memory.usedJSHeapSize")
        return used

    def close(self) -> None:
        """Check that the windows still show the page, and close them."""
        for page in self._pages:
            if page.get_by_text("This section of the page has stopped").count():
                self._report.violation(f"a section has stopped: {page.url}")
        self._browser.close()
        self._driver.stop()
