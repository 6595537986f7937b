"""Commands. Each noun has a module, or a folder if its verbs need several modules."""
