"""Futures and tasks."""

from zbot.executor.task import Future, FutureState, Task
