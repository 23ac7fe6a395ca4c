"""The papers' figures, made again: one file a paper, and the table of what came out."""
