"""Log of a launch, on the screen and in files. `launch.logging` of ROS 2 has the same names.

All launches of a process share `launch_config`, so they write to one folder in one format.
"""

from __future__ import annotations

import logging
import os
import warnings
from typing import TYPE_CHECKING, Any, Final, Literal

from zbot.launch.log import handlers
from zbot.launch.log.folder import make_unique_log_dir as _make_unique_log_dir
from zbot.launch.log.folder import renew_latest_log_dir as _renew_latest_log_dir
from zbot.launch.sink import parse_output
from zbot.log.log_file import get_logging_directory

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    Style = Literal["%", "{", "$"]

__all__ = [
    "LaunchConfig",
    "get_logger",
    "get_output_loggers",
    "handlers",
    "launch_config",
    "log_launch_config",
    "reset",
]

_SCREEN_FORMATS: Final = {
    "default": "[{levelname}] [{name}]: {message}",
    "default_with_timestamp": "{created:.7f} [{levelname}] [{name}]: {message}",
}
_NOWHERE: Final = logging.NullHandler()
_FILE_FORMATS: Final = {"default": _SCREEN_FORMATS["default_with_timestamp"]}


class LaunchConfig:
    """Settings of the log, which all launches in this process share."""

    file_handlers: dict[str, Any]
    screen_handler: Any
    screen_formatter: logging.Formatter
    file_formatter: logging.Formatter

    def __init__(self) -> None:
        self._loggers: dict[str, logging.Logger] = {}
        self.file_handlers = {}
        self.reset()

    def reset(self) -> None:
        """Restore the default settings."""
        self.close()
        self._log_dir: str | None = None
        self._base: str | None = None  #: parent of `_log_dir`
        self._has_warned = False  #: whether a warning about a missing folder was shown
        self.file_handlers = {}
        self.screen_handler = None
        self.log_file_name = "launch.log"
        self.log_handler_factory: Callable[..., logging.Handler] = handlers.LogFileHandler
        self._level = logging.INFO
        self.set_screen_format("default")
        self.set_log_format("default")

    def reset_loggers(self) -> None:
        """Remove handlers and levels from all loggers that the method `logger` returned."""
        for logger in self._loggers.values():
            logger.setLevel(logging.NOTSET)
            logger.handlers.clear()
        self._loggers.clear()

    def close(self) -> None:
        """Close the files. A later line opens its file again."""
        for handler in self.file_handlers.values():
            handler.close()

    def _forget_files(self) -> None:
        self.close()
        old = {id(handler) for handler in self.file_handlers.values()}
        for logger in self._loggers.values():
            logger.handlers[:] = [handler for handler in logger.handlers if id(handler) not in old]
        self.file_handlers.clear()

    @property
    def level(self) -> int:
        """The lowest level that is written."""
        return self._level

    @level.setter
    def level(self, level: int) -> None:
        for logger in self._loggers.values():
            if logger.level == self._level:  # the user did not set another level
                logger.setLevel(level)
        self._level = level

    @property
    def log_dir(self) -> str:
        """The folder of the log files. The first use creates it.

        Raises:
            OSError: The folder cannot be created.
        """
        base = str(get_logging_directory())
        if self._log_dir is None or self._base not in {None, base}:
            if self._log_dir is not None:  # the environment contains another folder now
                self._forget_files()
            self._base = base
            self._log_dir = _make_unique_log_dir(base_path=base)
            _renew_latest_log_dir(log_dir=self._log_dir)
        return self._log_dir

    @log_dir.setter
    def log_dir(self, folder: str | os.PathLike[str] | None) -> None:
        if folder is not None and not os.path.isdir(folder):  # noqa: PTH112
            raise ValueError(f"{folder} is not a directory")
        if folder is not None and self.file_handlers:
            text = f"log files are open below {self._log_dir}: they stay there"
            warnings.warn(text, stacklevel=2)
        self._log_dir, self._base = None if folder is None else str(folder), None

    def set_screen_format(self, screen_format: str, *, screen_style: Style | None = None) -> None:
        """Set the format of lines on the screen.

        If `$OVERRIDE_LAUNCH_SCREEN_FORMAT` is set, its value is used instead of `screen_format`.

        Args:
            screen_format: `default`, `default_with_timestamp`, or a format for `logging.Formatter`.
            screen_style: The style of the format's fields. None means `{`.

        Raises:
            ValueError: A style was given, but the format is a name such as `default`.
        """
        chosen = os.environ.get("OVERRIDE_LAUNCH_SCREEN_FORMAT")
        self.screen_formatter = _formatter(chosen, screen_format, screen_style, _SCREEN_FORMATS)
        if self.screen_handler is not None:
            self.screen_handler.setFormatter(self.screen_formatter)

    def set_log_format(self, log_format: str, *, log_style: Style | None = None) -> None:
        """Set the format of lines in files.

        If `$OVERRIDE_LAUNCH_LOG_FORMAT` is set, its value is used instead of `log_format`.

        Args:
            log_format: `default`, or a format for `logging.Formatter`.
            log_style: The style of the format's fields. None means `{`.

        Raises:
            ValueError: A style was given, but the format is a name such as `default`.
        """
        chosen = os.environ.get("OVERRIDE_LAUNCH_LOG_FORMAT")
        self.file_formatter = _formatter(chosen, log_format, log_style, _FILE_FORMATS)
        for handler in self.file_handlers.values():
            handler.setFormatter(self.file_formatter)

    def get_screen_handler(self) -> Any:
        """Return the handler that writes to the screen."""
        if self.screen_handler is None:
            self.screen_handler = handlers.ScreenHandler()
            self.screen_handler.setFormatter(self.screen_formatter)
        return self.screen_handler

    def get_log_file_path(self, file_name: str = "launch.log") -> str:
        """Return the path of a log file. The file may not exist yet."""
        return os.path.join(self.log_dir, file_name)  # noqa: PTH118 - a string, as in ROS 2

    def get_log_file_handler(self, file_name: str = "launch.log") -> Any:
        """Return the handler that writes to a file. `log_handler_factory` creates the handler.

        If the folder cannot be created, the screen shows one warning, and no file is written.
        """
        try:
            path = self.get_log_file_path(file_name)
        except OSError as error:
            if not self._has_warned:
                text = f"cannot write log files to {get_logging_directory()}: {error.strerror}"
                handlers.show(f"[WARNING] [launch]: {text}")
            self._has_warned = True
            return _NOWHERE
        if file_name not in self.file_handlers:
            handler = self.log_handler_factory(path, encoding="utf-8")
            handler.setFormatter(self.file_formatter)
            self.file_handlers[file_name] = handler
        return self.file_handlers[file_name]

    def logger(self, name: str) -> logging.Logger:
        """Return the logger that has this name.

        The first call gives the logger the level of the launch, if the logger has no level yet.
        """
        if name not in self._loggers:
            # The "root" of launch is a separate logger, because libraries write to Python's root
            # logger.
            logger = logging.getLogger(name) if name != "root" else logging.Logger("root")
            logger.propagate = False
            if logger.level == logging.NOTSET:
                logger.setLevel(self._level)
            self._loggers[name] = logger
        return self._loggers[name]


def _formatter(
    chosen: str | None, form: str, style: Style | None, known: Mapping[str, str]
) -> logging.Formatter:
    if chosen:
        return logging.Formatter(chosen.encode("latin1").decode("unicode_escape"), style="{")
    if form in known and style is not None:
        raise ValueError(f"the format '{form}' has its own style: leave out '{style}'")
    return logging.Formatter(known.get(form, form), style=style or "{")


launch_config = LaunchConfig()


def get_logger(name: str | None = None) -> logging.Logger:
    """Return a logger that writes to the screen and to the launch's log file."""
    logger = launch_config.logger(name or "root")
    _add(logger, launch_config.get_screen_handler())
    _add(logger, launch_config.get_log_file_handler(launch_config.log_file_name))
    return logger


def _add(logger: logging.Logger, handler: Any, form: str | None = None, style: Style = "{") -> None:
    if form is not None and hasattr(handler, "setFormatterFor"):
        handler.setFormatterFor(logger, logging.Formatter(form, style=style))
    if handler not in logger.handlers:
        logger.addHandler(handler)


def get_output_loggers(
    process_name: str,
    output_config: str | Mapping[str, Any],
    main_log_file_name: str = "launch.log",
) -> tuple[logging.Logger, logging.Logger]:
    """Return the loggers for stdout and stderr of a program.

    Args:
        process_name: The name in `NAME-stdout.log`, and in `NAME.log` for both streams.
        output_config: The sinks. The format is the same as in an action's `output`.
        main_log_file_name: The log file of the launch.

    Raises:
        ValueError: A word of `output_config` is unknown.
    """
    sinks = parse_output(output_config)
    both = sinks["both"]
    for stream in ("stdout", "stderr"):
        logger = launch_config.logger(f"{process_name}-{stream}")
        own = sinks[stream]
        # Remove the old handlers, because a second run of the same program may use other sinks.
        logger.handlers.clear()
        if "screen" in both | own:
            _add(logger, launch_config.get_screen_handler(), "{message}")
        if "log" in both | own:
            file = launch_config.get_log_file_handler(main_log_file_name)
            _add(logger, file, "{created:.7f} {message}")
        if "own_log" in own:
            name = f"{process_name}-{stream}.log"
            _add(logger, launch_config.get_log_file_handler(name), "{message}")
        if "own_log" in both:
            _add(logger, launch_config.get_log_file_handler(f"{process_name}.log"), "{message}")
    stdout, stderr = (
        launch_config.logger(f"{process_name}-{stream}") for stream in ("stdout", "stderr")
    )
    return stdout, stderr


def log_launch_config(*, logger: logging.Logger | None = None) -> None:
    """Log the folder of the log files and the present level."""
    logger = logger or get_logger()
    if launch_config.file_handlers:
        logger.info(f"All log files can be found below {launch_config.log_dir}")
    logger.info(f"Default logging verbosity is set to {logging.getLevelName(launch_config.level)}")


def reset() -> None:
    """Restore the default settings, and reset all loggers of the launch."""
    launch_config.reset_loggers()
    launch_config.reset()
