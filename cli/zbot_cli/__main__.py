"""`python -m zbot_cli` is `zbot`."""

from zbot_cli.main import main

main()
