"""One function per figure, each of plain arrays and names, returning matplotlib's Figure."""
