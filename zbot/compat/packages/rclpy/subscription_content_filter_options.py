"""Which messages a subscription wants."""

from zbot.subscription import ContentFilterOptions as ContentFilterOptions
