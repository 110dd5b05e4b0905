"""The composition roots, one per kind of process: all is made here from the settings."""
