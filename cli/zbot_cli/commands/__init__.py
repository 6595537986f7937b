"""Commands: a module for each noun, or a folder where its verbs fill one."""
