"""Programs that are measured, as Python source; each runs in a process of its own.

Every contestant does the same work: `zbot` and `rclpy` (where its wheels are installed) with typed
messages, a String up to 4 KiB and a UInt8MultiArray of 1 MB; `raw` is eclipse-zenoh alone, with
bytes of the same size. One-way messages are numbered, and missing ones are counted.
"""

from __future__ import annotations

ZBOT_HEAD = """
import sys, time, json, zbot
from std_msgs.msg import String, UInt8MultiArray
from zbot import QoSProfile, HistoryPolicy
import array
SIZE, COUNT = int(sys.argv[1]), int(sys.argv[2])
KEEP_ALL = QoSProfile(history=HistoryPolicy.KEEP_ALL)
TYPE = String if SIZE < 100_000 else UInt8MultiArray
def message():
    return String(data='x' * SIZE) if TYPE is String else TYPE(data=array.array('B', bytes(SIZE)))
"""

ZBOT_ECHO = (
    ZBOT_HEAD
    + """
with zbot.init():
    node = zbot.Node('echo')
    publisher = node.create_publisher(TYPE, 'pong', 10)
    node.create_subscription(TYPE, 'ping', publisher.publish, 10)
    zbot.spin(node)
"""
)

ZBOT_PING = (
    ZBOT_HEAD
    + """
trips, begun = [], 0
def go():
    global begun
    begun = time.perf_counter_ns(); publisher.publish(sample)
def on_pong(msg):
    trips.append(time.perf_counter_ns() - begun)
    go() if len(trips) < COUNT else zbot.shutdown()
with zbot.init():
    node = zbot.Node('ping'); sample = message()
    publisher = node.create_publisher(TYPE, 'ping', 10)
    node.create_subscription(TYPE, 'pong', on_pong, 10)
    while not (node.count_subscribers('ping') and node.count_publishers('pong')): time.sleep(0.01)
    go()
    zbot.spin(node)
print(json.dumps(trips[COUNT // 10:]))
"""
)

ZBOT_SINK = (
    ZBOT_HEAD
    + """
got, begun = 0, 0.0
def on_message(msg):
    global got, begun
    if got == 0: begun = time.perf_counter()
    got += 1
    if got == COUNT:
        print(json.dumps({'rate': COUNT / (time.perf_counter() - begun), 'lost': subscription.lost_count}))
        zbot.shutdown()
with zbot.init():
    node = zbot.Node('sink')
    subscription = node.create_subscription(TYPE, 'flood', on_message, KEEP_ALL)
    zbot.spin(node)
"""
)

ZBOT_FLOOD = (
    ZBOT_HEAD
    + """
with zbot.init():
    node = zbot.Node('flood'); sample = message()
    publisher = node.create_publisher(TYPE, 'flood', KEEP_ALL)
    while not node.count_subscribers('flood'): time.sleep(0.01)
    for _ in range(COUNT): publisher.publish(sample)
    while node.count_subscribers('flood'): time.sleep(0.01)
"""
)

RAW_HEAD = """
import sys, time, json, os, struct, threading, zenoh
NUMBER = struct.Struct('<q')
SIZE, COUNT, PORT = int(sys.argv[1]), int(sys.argv[2]), os.environ['BENCH_PORT']
def session(listens):
    config = zenoh.Config()
    config.insert_json5('mode', '"peer"')
    config.insert_json5('scouting/multicast/enabled', 'false')
    config.insert_json5('listen/endpoints' if listens else 'connect/endpoints', f'["tcp/127.0.0.1:{PORT}"]')
    config.insert_json5('connect/endpoints' if listens else 'listen/endpoints', '[]')
    config.insert_json5('connect/timeout_ms', '-1')
    config.insert_json5('connect/retry', '{period_init_ms: 20, period_max_ms: 100}')
    return zenoh.open(config)
BLOCK = dict(congestion_control=zenoh.CongestionControl.BLOCK)
def matched(publisher):
    while not publisher.matching_status.matching: time.sleep(0.01)
"""

RAW_ECHO = (
    RAW_HEAD
    + """
session = session(False)
publisher = session.declare_publisher('pong')
subscriber = session.declare_subscriber('ping', lambda sample: publisher.put(sample.payload.to_bytes()))
try:
    time.sleep(600)
finally:
    session.close()
"""
)

RAW_PING = (
    RAW_HEAD
    + """
trips, begun, done = [], 0, threading.Event()
session = session(True)
publisher = session.declare_publisher('ping'); sample = bytes(SIZE)
def go():
    global begun
    begun = time.perf_counter_ns(); publisher.put(sample)
def on_pong(reply):
    reply.payload.to_bytes()
    trips.append(time.perf_counter_ns() - begun)
    go() if len(trips) < COUNT else done.set()
subscriber = session.declare_subscriber('pong', on_pong)
matched(publisher)
go(); done.wait()
print(json.dumps(trips[COUNT // 10:])); session.close()
"""
)

# Losses are counted as zbot counts them, by numbers: the first eight bytes of each message.
RAW_SINK = (
    RAW_HEAD
    + """
got, lost, awaited, begun, done = 0, 0, 1, 0.0, threading.Event()
def on_message(sample):
    global got, lost, awaited, begun
    number, = NUMBER.unpack_from(sample.payload.to_bytes())
    if number != awaited: lost += number - awaited
    awaited = number + 1
    if got == 0: begun = time.perf_counter()
    got += 1
    if number == COUNT:
        print(json.dumps({'rate': got / (time.perf_counter() - begun), 'lost': lost})); done.set()
session = session(True)
subscriber = session.declare_subscriber('flood', on_message)
done.wait(); session.close()
"""
)

RAW_FLOOD = (
    RAW_HEAD
    + """
session = session(False)
publisher = session.declare_publisher('flood', **BLOCK); sample = bytearray(SIZE)
matched(publisher)
for number in range(1, COUNT + 1):
    NUMBER.pack_into(sample, 0, number); publisher.put(sample)
while publisher.matching_status.matching: time.sleep(0.01)
session.close()
"""
)

RCLPY_HEAD = """
import sys, time, json, array, rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, HistoryPolicy
from std_msgs.msg import String, UInt8MultiArray
SIZE, COUNT = int(sys.argv[1]), int(sys.argv[2])
TYPE = String if SIZE < 100_000 else UInt8MultiArray
def message():
    return String(data='x' * SIZE) if TYPE is String else TYPE(data=array.array('B', bytes(SIZE)))
rclpy.init()
"""

RCLPY_ECHO = (
    RCLPY_HEAD
    + """
node = Node('echo')
publisher = node.create_publisher(TYPE, 'pong', 10)
node.create_subscription(TYPE, 'ping', publisher.publish, 10)
rclpy.spin(node)
"""
)

RCLPY_PING = (
    RCLPY_HEAD
    + """
trips, begun = [], 0
def go():
    global begun
    begun = time.perf_counter_ns(); publisher.publish(sample)
def on_pong(msg):
    trips.append(time.perf_counter_ns() - begun)
    if len(trips) < COUNT: go()
node = Node('ping'); sample = message()
publisher = node.create_publisher(TYPE, 'ping', 10)
node.create_subscription(TYPE, 'pong', on_pong, 10)
while not (node.count_subscribers('ping') and node.count_publishers('pong')): time.sleep(0.05)
time.sleep(1); go()
while (count := len(trips)) < COUNT:
    rclpy.spin_once(node, timeout_sec=1)
    if len(trips) == count: go()  # a message was lost
print(json.dumps(trips[COUNT // 10:]))
"""
)

# rclpy's publisher raises when its queue is full, and a slow subscriber's messages are overwritten:
# the messages that reach the callback in five seconds are counted.
RCLPY_SINK = (
    RCLPY_HEAD
    + """
got, begun = 0, 0.0
def on_message(msg):
    global got, begun
    if got == 0: begun = time.perf_counter()
    got += 1
node = Node('sink')
node.create_subscription(TYPE, 'flood', on_message, 10)
while not got: rclpy.spin_once(node, timeout_sec=1)
while time.perf_counter() - begun < 5: rclpy.spin_once(node, timeout_sec=0.1)
print(json.dumps({'rate': got / (time.perf_counter() - begun), 'lost': None}))
"""
)

RCLPY_FLOOD = (
    RCLPY_HEAD
    + """
node = Node('flood'); sample = message()
publisher = node.create_publisher(TYPE, 'flood', 10)
while not node.count_subscribers('flood'): time.sleep(0.05)
end = time.perf_counter() + 7
while time.perf_counter() < end: publisher.publish(sample)
"""
)

# Services: AddTwoInts, whose request has SIZE bytes with zbot; SetBool with rclpy, whose wheels do
# not have AddTwoInts.
ZBOT_SERVER = """
import zbot
from example_interfaces.srv import AddTwoInts
def add(request, response):
    response.sum = request.a + request.b
    return response
with zbot.init():
    node = zbot.Node('server')
    node.create_service(AddTwoInts, 'add', add)
    zbot.spin(node)
"""

ZBOT_CALLER = """
import sys, time, json, zbot
from example_interfaces.srv import AddTwoInts
COUNT, trips = int(sys.argv[2]), []
with zbot.init():
    node = zbot.Node('caller')
    client = node.create_client(AddTwoInts, 'add'); request = AddTwoInts.Request(a=1, b=2)
    client.wait_for_service()
    for _ in range(COUNT):
        begun = time.perf_counter_ns()
        client.call(request)
        trips.append(time.perf_counter_ns() - begun)
print(json.dumps(trips[COUNT // 10:]))
"""

RAW_SERVER = (
    RAW_HEAD
    + """
session = session(False)
def answer(query):
    query.payload.to_bytes()
    query.reply('add', bytes(SIZE))
queryable = session.declare_queryable('add', answer, complete=True)
try:
    time.sleep(600)
finally:
    session.close()
"""
)

RAW_CALLER = (
    RAW_HEAD
    + """
trips = []
session = session(True)
querier = session.declare_querier('add'); sample = bytes(SIZE)
matched(querier)
for _ in range(COUNT):
    begun = time.perf_counter_ns()
    for reply in querier.get(payload=sample):
        reply.ok.payload.to_bytes()
    trips.append(time.perf_counter_ns() - begun)
print(json.dumps(trips[COUNT // 10:])); session.close()
"""
)

RCLPY_SERVER = """
import rclpy
from rclpy.node import Node
from std_srvs.srv import SetBool
def turn(request, response):
    response.success = request.data
    return response
rclpy.init()
node = Node('server')
node.create_service(SetBool, 'turn', turn)
rclpy.spin(node)
"""

RCLPY_CALLER = """
import sys, time, json, rclpy
from rclpy.node import Node
from std_srvs.srv import SetBool
COUNT, trips = int(sys.argv[2]), []
rclpy.init()
node = Node('caller')
client = node.create_client(SetBool, 'turn'); request = SetBool.Request(data=True)
client.wait_for_service()
for _ in range(COUNT):
    begun = time.perf_counter_ns()
    rclpy.spin_until_future_complete(node, client.call_async(request))
    trips.append(time.perf_counter_ns() - begun)
print(json.dumps(trips[COUNT // 10:]))
"""

SOURCES = {
    "zbot": (ZBOT_ECHO, ZBOT_PING, ZBOT_SINK, ZBOT_FLOOD),
    "raw": (RAW_ECHO, RAW_PING, RAW_SINK, RAW_FLOOD),
    "rclpy": (RCLPY_ECHO, RCLPY_PING, RCLPY_SINK, RCLPY_FLOOD),
}
SERVICES = {
    "zbot": (ZBOT_SERVER, ZBOT_CALLER),
    "raw": (RAW_SERVER, RAW_CALLER),
    "rclpy": (RCLPY_SERVER, RCLPY_CALLER),
}
