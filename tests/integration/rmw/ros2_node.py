"""Node that knows only the specification of rmw_zenoh: plain Zenoh, and nothing of zbot."""

from __future__ import annotations

import json
import struct
import time
from typing import Any

import zenoh
import zenoh.ext

STRING = (
    "std_msgs::msg::dds_::String_",
    "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18",
)
ADD = (
    "example_interfaces::srv::dds_::AddTwoInts_",
    "RIHS01_e118de6bf5eeb66a2491b5bda11202e7b68f198d6f67922cf30364858239c81a",
)
DEFAULT = "::,10:,:,:,,"
LATCHED = ":1:,3:,:,:,,"


def string(text: str) -> bytes:
    """Return a std_msgs/msg/String in CDR."""
    data = text.encode() + b"\0"
    return b"\0\1\0\0" + struct.pack("<I", len(data)) + data


def open_session(settings: dict[str, Any]) -> zenoh.Session:
    config = zenoh.Config()
    for path, value in {
        "scouting/multicast/enabled": False,
        "scouting/delay": 1,
        "connect/retry": {"period_init_ms": 20, "period_max_ms": 500, "period_increase_factor": 2},
        **settings,
    }.items():
        config.insert_json5(path, json.dumps(value))
    return zenoh.open(config)


def text_of(payload: bytes) -> str:
    return payload[8:-1].decode()


class Ros2Node:
    """A node of ROS 2, with a session of its own.

    Args:
        endpoint: The router. Without it, the session finds others by multicast.
        domain: The domain.
        **settings: Zenoh's configuration, with `__` for `/`.
    """

    def __init__(self, endpoint: str, domain: int, name: str = "plain", **settings: Any) -> None:
        self._endpoint = endpoint
        self.session = open_session(
            {
                "mode": "peer",
                "connect/endpoints": [endpoint] if endpoint else [],
                "listen/endpoints": ["tcp/127.0.0.1:0"],
                "timestamping/enabled": True,
                **{path.replace("__", "/"): value for path, value in settings.items()},
            }
        )
        self.domain, self.name = domain, name
        self.zid = str(self.session.info.zid())
        self.gid = bytes(range(16))
        self._ids = iter(range(1000))
        self._kept: list[Any] = []
        self._sent = 0
        number = next(self._ids)
        self._announce(f"{number}/{number}/NN/%/%/{name}")

    def _announce(self, rest: str) -> None:
        key = f"@ros2_lv/{self.domain}/{self.zid}/{rest}"
        self._kept.append(self.session.liveliness().declare_token(key))

    def announce(self, kind: str, name: str, of_type: tuple[str, str], qos: str = DEFAULT) -> str:
        """Announce an endpoint, and return the key of its messages."""
        mangled = name.replace("/", "%")
        self._announce(
            f"0/{next(self._ids)}/{kind}/%/%/{self.name}/{mangled}/{of_type[0]}/{of_type[1]}/{qos}"
        )
        return self._key(name, of_type)

    def _key(self, name: str, of_type: tuple[str, str]) -> str:
        return "/".join((f"{self.domain}{name}", *of_type))

    def attachment(self, number: int | None = None, gid: bytes | None = None) -> bytes:
        self._sent += 1
        number = self._sent if number is None else number
        return struct.pack("<qqB", number, time.time_ns(), 16) + (gid or self.gid)

    def subscribe(self, name: str, of_type: tuple[str, str] = STRING, qos: str = DEFAULT) -> Any:
        """Return the list of the samples of a topic."""
        samples: list[Any] = []
        key = self._key(name, of_type)
        if qos == LATCHED:
            subscriber: Any = zenoh.ext.declare_advanced_subscriber(
                self.session,
                key,
                samples.append,
                history=zenoh.ext.HistoryConfig(detect_late_publishers=True, max_samples=3),
                recovery=zenoh.ext.RecoveryConfig(periodic_queries=None, heartbeat=True),
                subscriber_detection=True,
            )
        else:
            subscriber = self.session.declare_subscriber(key, samples.append)
        self._kept.append(subscriber)
        self.announce("MS", name, of_type, qos)  # who sees the token reaches the subscriber
        return samples

    def publisher(self, name: str, of_type: tuple[str, str] = STRING, qos: str = DEFAULT) -> Any:
        key = self.announce("MP", name, of_type, qos)
        if qos == LATCHED:
            publisher: Any = zenoh.ext.declare_advanced_publisher(
                self.session,
                key,
                cache=zenoh.ext.CacheConfig(3),
                publisher_detection=True,
                sample_miss_detection=zenoh.ext.MissDetectionConfig(
                    heartbeat=None, sporadic_heartbeat=0.5
                ),
            )
        else:
            publisher = self.session.declare_publisher(key)
        self._kept.append(publisher)
        return publisher

    def serve_sum(self, name: str) -> list[bytes]:
        """Serve AddTwoInts, and return the list of the requests' attachments."""
        seen: list[bytes] = []

        def answer(query: zenoh.Query) -> None:
            assert query.payload is not None
            assert query.attachment is not None
            facts = query.attachment.to_bytes()
            seen.append(facts)
            one, other = struct.unpack("<qq", query.payload.to_bytes()[4:])
            payload = b"\0\1\0\0" + struct.pack("<q", one + other)
            number = struct.unpack("<q", facts[:8])[0]
            query.reply(query.key_expr, payload, attachment=self.attachment(number, facts[17:]))
            query.drop()

        key = self._key(name, ADD)
        self._kept.append(self.session.declare_queryable(key, answer, complete=True))
        self.announce("SS", name, ADD)
        return seen

    def call(self, key: str, payload: bytes, attachment: bytes | None) -> list[zenoh.Reply]:
        return list(
            self.session.get(
                key,
                payload=payload,
                attachment=attachment,
                target=zenoh.QueryTarget.ALL_COMPLETE,
                consolidation=zenoh.ConsolidationMode.NONE,
                timeout=10,
            )
        )

    def tokens(self) -> list[str]:
        """Return the keys of the tokens that the router has."""
        key = f"@ros2_lv/{self.domain}/**"
        with open_session({"mode": "client", "connect/endpoints": [self._endpoint]}) as client:
            found = client.liveliness().get(key, zenoh.handlers.FifoChannel(10_000))
            return sorted(str(reply.ok.key_expr) for reply in found if reply.ok is not None)

    def close(self) -> None:
        self.session.close()
