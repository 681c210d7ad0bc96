#!/usr/bin/env python3
"""Writes a star with a smooth outline of COUNT points as a .poly file to standard output: at most sizes its outline is
far finer than what is inside."""
import argparse
import math

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("count", type=int, help="points of the outline")
count = parser.parse_args().count
print(count, 2, 0, 0)
for i in range(count):
    turn = 2 * math.pi * i / count
    radius = 1 + 0.2 * math.sin(9 * turn)
    print(i, radius * math.cos(turn), radius * math.sin(turn))
print(count, 0)
for i in range(count):
    print(i, i, (i + 1) % count)
print(0)
