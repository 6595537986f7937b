"""Tags and substitutions of one's own."""

from zbot.launch.frontend.registry import expose as __expose_impl
from zbot.launch.frontend.registry import expose_action as expose_action
from zbot.launch.frontend.registry import expose_substitution as expose_substitution
