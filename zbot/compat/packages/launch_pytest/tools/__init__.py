"""Waiting for processes."""

from zbot.compat.submodules import submodules as submodules

__getattr__ = submodules(__name__, "process")
