"""Program of `zbot` and `python -m zbot_cli`.

Ctrl-C is handled before the other imports, because it may come while they run.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    import signal
else:
    import _signal as signal  # built into Python, so no file is read before Ctrl-C is handled

if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

from zbot_cli.input import keyboard_interrupt  # noqa: E402

keyboard_interrupt.end_process_on_ctrl_c()

from zbot_cli.main import main  # noqa: E402

if __name__ == "__main__":
    main()
