"""The Voronoi roadmap of paper 001, and the paths along it."""
