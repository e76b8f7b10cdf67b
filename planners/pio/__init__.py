"""Pigeon-inspired optimisation of paper 001: the standard one (PIO), and the improved one (GCCPIO)."""
