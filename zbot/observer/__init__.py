"""Hidden node that watches a domain for a viewer: topics, rates, log lines and requests."""
