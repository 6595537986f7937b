"""Options of a subscription that takes only some messages."""

from zbot.node.content_filter_options import ContentFilterOptions
