"""`zbot`, and `python -m zbot_cli`: the way into the command.

Imports come after the first line that does something, for Ctrl-C may come before they are over.
"""

from zbot_cli.input import interruption

interruption.end_at_once()

from zbot_cli.main import main  # noqa: E402

if __name__ == "__main__":
    main()
