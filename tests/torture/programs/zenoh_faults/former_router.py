"""Fault of Zenoh 1.10: a router hides the tokens of a peer that was linked to another router.

Run: former_router.py

If a peer is linked to several routers, only the router with the greatest id passes the peer's
tokens, subscribers and queryables on to other routers. Here this is the router that ends. The
router that stays never passes on what the peer had declared before, also not on a new link.
"""

from __future__ import annotations

import json
import socket
import sys
import time

import zenoh

_KEY = "token"
_SETTLE_S = 1.0


def _open(mode: str, port: int, connect: list[int], zid: str | None = None) -> zenoh.Session:
    config = zenoh.Config()
    settings = {
        "mode": mode,
        "listen/endpoints": [f"tcp/127.0.0.1:{port}"] if port else [],
        "connect/endpoints": [f"tcp/127.0.0.1:{other}" for other in connect],
        "scouting/multicast/enabled": False,
        **({"id": zid} if zid else {}),
    }
    for path, value in settings.items():
        config.insert_json5(path, json.dumps(value))
    return zenoh.open(config)


def _free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as server:
        return int(server.getsockname()[1])


def _knows_token(session: zenoh.Session) -> bool:
    return any(reply.ok for reply in session.liveliness().get(_KEY, timeout=1.0))


def main() -> int:
    former_port, port = _free_port(), _free_port()
    former = _open("router", former_port, [], "20" * 16)
    with (
        _open("router", port, [], "10" * 16),
        _open("peer", _free_port(), [former_port, port]) as owner,
    ):
        time.sleep(_SETTLE_S)
        with owner.liveliness().declare_token(_KEY):
            former.close()
            time.sleep(_SETTLE_S)
            with _open("client", 0, [port]) as client, _open("router", 0, [port]) as router:
                time.sleep(_SETTLE_S)
                is_there, is_passed_on = _knows_token(client), _knows_token(router)
    if not is_there:
        print("the router does not know the token, so this run says nothing")
        return 2
    print(f"the router {'passes' if is_passed_on else 'does not pass'} the peer's token on")
    return 0 if is_passed_on else 1


if __name__ == "__main__":
    sys.exit(main())
