"""Sketches: a sentence in the plan language's own form, and what it means in a scene."""
