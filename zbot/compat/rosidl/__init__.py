"""Functions of `rosidl_adapter`, which read definitions, and of `rosidl_runtime_py`."""
