"""Error that a failed substitution raises."""

from zbot.launch.errors import SubstitutionError as SubstitutionFailure

__all__ = ["SubstitutionFailure"]
