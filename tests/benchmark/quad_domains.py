"""Planar domains with given, even boundaries for quads.py. The first loop is the outer one."""
import dataclasses
import json
import math
import random


@dataclasses.dataclass
class Domain:
    loops: list
    holes: list = dataclasses.field(default_factory=list)  # a point in each
    sizes: dict = None  # for `af2 mesh --sizes`; none: the size is the same everywhere


def divided(corners, size):
    """A polygon whose sides are divided, with an even number of segments in all."""
    sides = list(zip(corners, corners[1:] + corners[:1]))
    counts = [max(1, round(math.dist(a, b) / size)) for a, b in sides]
    if sum(counts) % 2:
        counts[counts.index(max(counts))] += 1
    return [(a[0] + k / n * (b[0] - a[0]), a[1] + k / n * (b[1] - a[1]))
            for (a, b), n in zip(sides, counts) for k in range(n)]


def arc(radius, begin, end, size, centre=(0, 0), segments=0):
    n = segments or max(1, round(radius * (end - begin) / size))
    angles = [begin + (end - begin) * k / n for k in range(n)]
    return [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in angles]


def circle(x, y, radius, size):
    n = max(6, 2 * round(math.pi * radius / size))
    return arc(radius, 0, 2 * math.pi, size, (x, y), n)


def gear(size):
    pitch, outline = 2 * math.pi / 12, []
    at = lambda radius, angle: (radius * math.cos(angle), radius * math.sin(angle))
    for tooth in range(12):
        begin = tooth * pitch
        root, rise, tip, fall = (begin + share * pitch for share in (.34, .46, .88, 1))
        outline += arc(.38, begin, root, size)
        outline += flank(at(.38, root), at(.5, rise), size)
        outline += arc(.5, rise, tip, size)
        outline += flank(at(.5, tip), at(.38, fall), size)
    return outline


def flank(a, b, size):
    n = max(1, round(math.dist(a, b) / size))
    return [(a[0] + k / n * (b[0] - a[0]), a[1] + k / n * (b[1] - a[1])) for k in range(n)]


def airfoil(size):
    """NACA 0012, of length 1."""
    half = lambda x: .6 * (.2969 * math.sqrt(x) - .126 * x - .3516 * x**2 + .2843 * x**3 - .1036 * x**4)
    n = max(8, round(1.02 / size))
    upper = [(x, half(x)) for x in (.5 * (1 - math.cos(math.pi * k / n)) for k in range(n + 1))]
    return upper[::-1] + [(x, -y) for x, y in upper[1:-1]]


def graded(size):
    """A unit square over which sizes grow fourfold, from 0.4 to 1.6 of the size."""
    low, high = .4 * size, 1.6 * size
    across = round(math.log(high / low) / (high - low))
    xs = [low * ((high / low) ** (k / across) - 1) / (high - low) for k in range(across)]
    left, right = round(1 / low), round(1 / high)
    right += (left + right) % 2
    outline = ([(x, 0) for x in xs] + [(1, k / right) for k in range(right)] +
               [(x, 1) for x in [1] + xs[:0:-1]] + [(0, 1 - k / left) for k in range(left)])
    field = {"origin": [0, 0, 0], "spacing": [1, 1, 1], "counts": [2, 2, 1], "sizes": [low, high, low, high]}
    return Domain([outline], [], {"fields": [field]})


def named(size):
    square = divided([(0, 0), (1, 0), (1, 1), (0, 1)], size)
    box = divided([(-.5, -.75), (1.5, -.75), (1.5, .75), (-.5, .75)], size)
    corner = divided([(0, 0), (1, 0), (1, .5), (.5, .5), (.5, 1), (0, 1)], size)
    rectangle = divided([(0, 0), (1, 0), (1, .6), (0, .6)], size)
    return {"square with hole": Domain([square, circle(.5, .5, .2, size)], [(.5, .5)]),
            "gear": Domain([gear(size), circle(0, 0, .12, size)], [(0, 0)]),
            "disc": Domain([circle(0, 0, .5, size)]),
            "eccentric annulus": Domain([circle(0, 0, .5, size), circle(.15, 0, .2, size)], [(.15, 0)]),
            "airfoil in a box": Domain([box, airfoil(size)], [(.5, 0)]),
            "L-shape": Domain([corner]),
            "rectangle": Domain([rectangle]),
            "graded square": graded(size)}


def wavy_loop(numbers, centre, radius, wave, size, is_uneven):
    """A circle with waves of two to four periods, with an even number of segments."""
    waves = [(numbers.uniform(0, wave), numbers.uniform(0, 2 * math.pi)) for _ in range(3)]

    def at(part):
        angle = 2 * math.pi * part
        r = radius * (1 + sum(h * math.cos((k + 2) * angle + phase) for k, (h, phase) in enumerate(waves)))
        return centre[0] + r * math.cos(angle), centre[1] + r * math.sin(angle)

    samples = 2000
    points = [at(k / samples) for k in range(samples + 1)]
    lengths = [0]
    for p, q in zip(points, points[1:]):
        lengths.append(lengths[-1] + math.dist(p, q))
    count = 2 * max(3, round(lengths[-1] / size / 2))
    shares = [numbers.uniform(.6, 1.4) if is_uneven else 1 for _ in range(count)]
    loop, sample, done = [], 0, 0
    for share in shares:
        wanted = done / sum(shares) * lengths[-1]
        while lengths[sample + 1] <= wanted:
            sample += 1
        rest = (wanted - lengths[sample]) / (lengths[sample + 1] - lengths[sample])
        loop.append(at((sample + rest) / samples))
        done += share
    return loop


def random_domain(seed, size, is_uneven):
    """A smooth region with 0 to 3 holes. Its segments are as long as the size, or 0.6 to 1.4 times as long."""
    numbers = random.Random(seed)
    loops, holes = [wavy_loop(numbers, (0, 0), .6, .1, size, is_uneven)], []
    count, turn = seed % 4, numbers.random()
    for i in range(count):
        angle = 2 * math.pi * (turn + (i + numbers.uniform(-.05, .05)) / count)
        away = numbers.uniform(.2, .25)
        centre = away * math.cos(angle), away * math.sin(angle)
        loops.append(wavy_loop(numbers, centre, numbers.uniform(.07, .11), .08, size, is_uneven))
        holes.append(centre)
    return Domain(loops, holes)


def write_poly(path, domain):
    """Also writes the sizes, if they vary; returns the options of `af2 mesh` for both files."""
    points, segments = [], []
    for loop in domain.loops:
        first = len(points) + 1
        points += loop
        segments += [(first + i, first + (i + 1) % len(loop)) for i in range(len(loop))]
    lines = [f"{len(points)} 2 0 0"] + [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(points, 1)]
    lines += [f"{len(segments)} 0"] + [f"{i} {a} {b}" for i, (a, b) in enumerate(segments, 1)]
    lines += [str(len(domain.holes))] + [f"{i} {x} {y}" for i, (x, y) in enumerate(domain.holes, 1)]
    path.write_text("\n".join(lines) + "\n")
    if not domain.sizes:
        return ["--keep-boundary"]
    path.with_suffix(".json").write_text(json.dumps(domain.sizes))
    return ["--keep-boundary", "--sizes", str(path.with_suffix(".json"))]
