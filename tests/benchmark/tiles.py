#!/usr/bin/env python3
"""A square of side 10 in N x N equal squares, each a face of its own, as .poly: tiles.py N > tiles.poly"""
import sys

n = int(sys.argv[1])
points = [(10 * i / n, 10 * j / n) for j in range(n + 1) for i in range(n + 1)]


def number(i, j):
    return j * (n + 1) + i + 1


segments = [(number(i, j), number(i + 1, j)) for j in range(n + 1) for i in range(n)]
segments += [(number(i, j), number(i, j + 1)) for i in range(n + 1) for j in range(n)]
print(len(points), "2 0 0")
for k, (x, y) in enumerate(points):
    print(k + 1, x, y)
print(len(segments), 0)
for k, (a, b) in enumerate(segments):
    print(k + 1, a, b)
print(0)
