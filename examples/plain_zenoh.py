"""Read a zbot topic with only eclipse-zenoh and msgpack. docs/wire.md explains the format."""

import os

import msgpack
import zenoh

domain = int(os.environ.get("ZBOT_DOMAIN_ID", "0"))
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", f'["tcp/127.0.0.1:{7450 + domain}"]')

if __name__ == "__main__":
    with zenoh.open(config) as session:
        readings = session.declare_subscriber(f"{domain}/temperature")
        for sample in readings:
            reading = msgpack.unpackb(sample.payload.to_bytes())
            print(f"{reading['data']:.2f} degrees", flush=True)
