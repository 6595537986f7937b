"""Which messages a subscription wants."""

from zbot.node.subscription import ContentFilterOptions as ContentFilterOptions
