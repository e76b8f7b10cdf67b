"""Ant colonies: paper 000 (Li et al., improved ACO for flight vehicles), basic and improved, and turn-aware ants."""
