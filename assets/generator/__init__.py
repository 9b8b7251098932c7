"""The generator of Timeshade's three scenes: plain Python, standard library only."""
