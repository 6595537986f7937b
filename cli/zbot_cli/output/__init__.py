"""Output: listings, messages, plots and errors as text."""
