"""Animations of a result: films (GIF, MP4), and a player as one HTML file."""
