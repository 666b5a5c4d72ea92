"""Scenes, bodies, files and certificates that the tests are about, each kind with its truth."""
