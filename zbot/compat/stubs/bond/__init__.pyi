# Written by python -m zbot.interfaces.stubs; do not edit.
from bond import msg as msg
