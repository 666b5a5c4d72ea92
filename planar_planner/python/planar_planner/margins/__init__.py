"""The margin: how far the robot can grow or must shrink (docs/margin.md)."""
