# Written by python -m zbot.interfaces.stubs; do not edit.
from std_srvs import srv as srv
