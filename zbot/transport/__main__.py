"""Background process with the router of a domain. zbot runs `python -m zbot.transport DOMAIN`."""

from __future__ import annotations

import queue
import sys
import time
from typing import Any

import zenoh

from zbot.memory import give_back_freed_memory
from zbot.threads.deadline import Deadline
from zbot.transport import background_process, config, router_process
from zbot.transport.process_facts import process_facts
from zbot.transport.router_renewal import RouterRenewal
from zbot.transport.session import MeetingPoint
from zbot.version import __version__

# Time that the router waits for a new program. Commands and tests often follow each other.
_LINGER_S = 2.0
# The system may refuse the port for a moment after the last process on the port was killed.
_BIND_TIMEOUT_S = 2.0
_BIND_PAUSE_S = 0.02


def main() -> int:
    """Run the router until no program was linked for 2 s. Return 1 if the port is not free.

    After many programs have come and gone, the router closes its session and opens a new one.
    """
    domain = int(sys.argv[1])
    lock = router_process.hold_lock(domain)
    background_process.remove_old_locks()
    facts = process_facts(__version__)
    facts["zbot"]["command"] = f"router of domain {domain}"
    facts["zbot"]["replaces"] = sys.argv[2:] == [router_process.REPLACEMENT]
    meeting = MeetingPoint(config.load(), domain, config.discovery_range(), facts)
    while (session := _opened(meeting)) is not None:
        if _is_alone_at_end(session):
            router_process.note_end(domain)
            session.close()
            del lock
            return 0
        router_process.note_new_session(domain)
        session.close()
        del session
        give_back_freed_memory()  # of all keys of the former session
        # Commands wait until the programs are linked to the new session.
        facts["zbot"] |= {"started": time.time_ns(), "replaces": True}
    return 1


def _opened(meeting: MeetingPoint) -> zenoh.Session | None:
    """Return the router's session, or `None` if the port is not free."""
    session, deadline = meeting.open_router(), Deadline(_BIND_TIMEOUT_S)
    while session is None and not meeting.is_taken() and not deadline.is_over:
        time.sleep(_BIND_PAUSE_S)
        session = meeting.open_router()
    return session


def _is_alone_at_end(session: zenoh.Session) -> bool:
    """Wait until no program is linked, or until the session has to be renewed.

    Return whether no program is linked.
    """
    events: queue.SimpleQueue[Any] = queue.SimpleQueue()
    handler = zenoh.handlers.Callback(events.put)
    listener = session.info.declare_transport_events_listener(handler, history=True)
    renewal = RouterRenewal(session, lambda: events.put(None))
    programs: set[str] = set()
    try:
        while (event := events.get(timeout=None if programs else _LINGER_S)) is not None:
            programs = _after(event, programs)
    except queue.Empty:
        return True
    else:
        return False
    finally:
        listener.undeclare()
        renewal.end()


def _after(event: Any, programs: set[str]) -> set[str]:
    """Return the ids of the linked programs after an event. Routers are not programs."""
    changed = (
        {str(event.transport.zid)} if event.transport.whatami != zenoh.WhatAmI.ROUTER else set()
    )
    return programs - changed if event.kind == zenoh.SampleKind.DELETE else programs | changed


if __name__ == "__main__":
    sys.exit(main())
