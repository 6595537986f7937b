"""Futures and tasks."""

from zbot.executor.task import Future as Future
from zbot.executor.task import FutureState as FutureState
from zbot.executor.task import Task as Task
