"""Talker, listener, server or client of another implementation of rmw_zenoh.

Run: other_ros2.py pyzeros|sdk talk|listen|serve|call. The environment has ROS_DOMAIN_ID, and
ZENOH_CONFIG_OVERRIDE with the configuration of the session.
"""

import asyncio
import os
import sys
import threading
from dataclasses import dataclass

STRING_HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
ADD_HASH = "RIHS01_e118de6bf5eeb66a2491b5bda11202e7b68f198d6f67922cf30364858239c81a"
DOMAIN = int(os.environ["ROS_DOMAIN_ID"])


def tell(*words):
    print(*words, flush=True)


def run_pyzeros(role):
    import asyncio_for_robotics as afor
    import pyzeros
    import zenoh
    from ros2_pyterfaces.cyclone.all_msgs import String
    from ros2_pyterfaces.cyclone.idl import IdlStruct, make_idl_service, types

    @dataclass
    class Request(IdlStruct, typename="example_interfaces/srv/AddTwoInts_Request"):
        a: types.int64 = 0
        b: types.int64 = 0

    @dataclass
    class Response(IdlStruct, typename="example_interfaces/srv/AddTwoInts_Response"):
        sum: types.int64 = 0

    add = make_idl_service(Request, Response)

    async def talk():
        publisher = pyzeros.Pub(String, "chatter")
        async for _ in afor.Rate(10).listen():
            publisher.publish(String(data="hi"))

    async def listen():
        async for message in pyzeros.Sub(String, "chatter").listen_reliable():
            tell("heard", message.data)

    async def serve():
        async for responder in pyzeros.Server(add, "add").listen_reliable():
            responder.response.sum = responder.request.a + responder.request.b
            responder.send()

    async def call():
        client = pyzeros.Client(add, "add")
        await client.wait_for_service()
        tell("sum", (await client.call_async(add.Request(a=40, b=2))).sum)

    config = zenoh.Config()
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("timestamping/enabled", "true")
    for part in os.environ["ZENOH_CONFIG_OVERRIDE"].split(";"):
        config.insert_json5(*part.split("=", 1))
    roles = {"talk": talk, "listen": listen, "serve": serve, "call": call}
    with (
        zenoh.open(config) as session,
        pyzeros.auto_context(node="other", zenoh_session=session, domain_id=DOMAIN),
    ):
        tell("ready")
        asyncio.run(afor.scoped(roles[role])())


def run_sdk(role):
    import zenoh_ros2_sdk as sdk

    topic = {
        "topic": "/chatter",
        "msg_type": "std_msgs/msg/String",
        "msg_definition": "string data\n",
        "type_hash": STRING_HASH,
        "node_name": "other",
        "domain_id": DOMAIN,
    }
    service = {
        "service_name": "/add",
        "srv_type": "example_interfaces/srv/AddTwoInts",
        "request_definition": "int64 a\nint64 b\n",
        "response_definition": "int64 sum\n",
        "type_hash": ADD_HASH,
        "node_name": "other",
        "domain_id": DOMAIN,
    }
    never = threading.Event()
    if role == "talk":
        publisher = sdk.ROS2Publisher(**topic)
        tell("ready")
        while not never.wait(0.1):
            publisher.publish(data="hi")
    elif role == "listen":
        kept = sdk.ROS2Subscriber(callback=lambda message: tell("heard", message.data), **topic)
        tell("ready", kept)
        never.wait()
    elif role == "serve":

        def answer(request):
            return kept.response_msg_class(sum=request.a + request.b)

        kept = sdk.ROS2ServiceServer(callback=answer, **service)
        tell("ready", kept)
        never.wait()
    else:
        client = sdk.ROS2ServiceClient(**service)
        tell("ready")
        response = None
        while response is None:
            response = client.call(a=40, b=2)
        tell("sum", response.sum)


if __name__ == "__main__":
    {"pyzeros": run_pyzeros, "sdk": run_sdk}[sys.argv[1]](sys.argv[2])
