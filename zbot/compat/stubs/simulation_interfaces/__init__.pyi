# Written by python -m zbot.interfaces.stubs; do not edit.
from simulation_interfaces import action as action
from simulation_interfaces import msg as msg
from simulation_interfaces import srv as srv
