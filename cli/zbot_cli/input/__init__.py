"""Input: options, types and values as they are typed."""
