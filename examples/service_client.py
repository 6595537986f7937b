"""Client of a service: it sends one request, waits for the response, and ends."""

import zbot

from example_interfaces.srv import AddTwoInts

if __name__ == "__main__":
    with zbot.init():
        node = zbot.Node("client")
        client = node.create_client(AddTwoInts, "add_two_ints")
        if not client.wait_for_service(timeout_sec=10):
            raise SystemExit("no server: start service_server.py first")
        response = client.call(AddTwoInts.Request(a=2, b=3))
        print("2 + 3 =", response.sum)
