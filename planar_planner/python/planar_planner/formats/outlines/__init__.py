"""The geometry of imported outlines: curves, chains of edges, rings, faces, cells of images."""
