# Written by python -m zbot.compat.generator; do not edit.
"""Domains for tests that run at the same time."""

from zbot.testing.domain import reserved_domain as domain_id

__all__ = [
    "domain_id",
]
