"""How far a scene is from its other verdict: the robot grown or shrunk (docs/margin.md)."""
