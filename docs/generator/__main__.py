"""Write the page of the commands, which is kept in the checkout: `python -m docs.generator`."""

from docs.generator import write_commands

write_commands()
