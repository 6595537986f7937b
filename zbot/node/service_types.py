"""Types and type hashes of the services that every node has.

They never change in ROS 2. They are constants, so that the classes of these types are loaded only
at the first request. To load them would double the time to create a node.
"""

from __future__ import annotations

DESCRIPTION_SERVICE = (
    "type_description_interfaces/srv/GetTypeDescription",
    "RIHS01_69b9c19c1021405984cc60dbbb1edceb147a6538b411d812ba6afabeed962cd5",
)
PARAMETER_SERVICES = {
    "describe_parameters": (
        "rcl_interfaces/srv/DescribeParameters",
        "RIHS01_845b484d71eb0673dae682f2e3ba3c4851a65a3dcfb97bddd82c5b57e91e4cff",
    ),
    "get_parameter_types": (
        "rcl_interfaces/srv/GetParameterTypes",
        "RIHS01_da199c878688b3e530bdfe3ca8f74cb9fa0c303101e980a9e8f260e25e1c80ca",
    ),
    "get_parameters": (
        "rcl_interfaces/srv/GetParameters",
        "RIHS01_bf9803d5c74cf989a5de3e0c2e99444599a627c7ff75f97b8c05b01003675cbc",
    ),
    "list_parameters": (
        "rcl_interfaces/srv/ListParameters",
        "RIHS01_3e6062bfbb27bfb8730d4cef2558221f51a11646d78e7bb30a1e83afac3aad9d",
    ),
    "set_parameters": (
        "rcl_interfaces/srv/SetParameters",
        "RIHS01_56eed9a67e169f9cb6c1f987bc88f868c14a8fc9f743a263bc734c154015d7e0",
    ),
    "set_parameters_atomically": (
        "rcl_interfaces/srv/SetParametersAtomically",
        "RIHS01_0e192ef259c07fc3c07a13191d27002222e65e00ccec653ca05e856f79285fcd",
    ),
}
