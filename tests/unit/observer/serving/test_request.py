from __future__ import annotations

import pytest

from zbot.observer.serving.request import RequestError, parsed


@pytest.mark.parametrize(
    "head",
    [
        b"\r\n\r\n",
        b"GET http://a/ HTTP/1.1\r\n\r\n",
        b"GET / HTTP/2\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost : a\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n",
        b"GET / HTTP/1.1\r\nA: b\nOrigin: c\r\n\r\n",
    ],
)
def test_bytes_that_are_no_request_are_refused(head: bytes) -> None:
    with pytest.raises(RequestError):
        parsed(head)
