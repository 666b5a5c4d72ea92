"""Bodies whose depths are asked for: random ones, degenerate pairs, outlines after a paper."""
