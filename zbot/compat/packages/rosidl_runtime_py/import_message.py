"""Function that finds a class by its type."""

from zbot.compat.rosidl.lookup import (
    import_message_from_namespaced_type,
)
