"""Classes by their types."""

from zbot.interfaces.lookup import (
    import_message_from_namespaced_type as import_message_from_namespaced_type,
)
