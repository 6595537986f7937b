"""Which messages a subscription wants."""

from zbot.node.content_filter_options import ContentFilterOptions as ContentFilterOptions
