"""Parts of the live page that all panels use."""
