"""What the benchmarks of grasps measure: block, hand, situations, linearised cones, pictures."""
