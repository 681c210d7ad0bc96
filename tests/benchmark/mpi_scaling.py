"""mpi_scaling.py REPORT [--latency SECONDS] [--bandwidth BYTES_PER_SECOND] [--strips SHARE] [--ranks N,N,...]

How long af2-mpi would take on many ranks, simulated from what a run on one thread has cost:

    af2 mesh MODEL --size S --threads 1 --report REPORT

The simulation plays what mpi/crew does. Each rank reads the model and prepares it; rank 0 divides the edges and
sends them through a tree. Whoever is free asks rank 0 for the next faces, the most work first; once all faces are
begun, those who are free take pieces of large faces, for which they cut the face once more. The owner of a cut face
waits for its pieces, then joins them and optimises along the cuts, level by level. All meshes go to rank 0, which
joins and checks them."""

import argparse
import heapq
import json
import math

PIECE_ELEMENTS = 80000  # SplitOptions::pieceElements
BYTES_OF_ELEMENT = 45  # a message of face meshes, per triangle: half a vertex, its corners, its rule
COPY_BYTES_PER_SECOND = 1.5e9  # how fast rank 0 turns messages into meshes, on the thread that receives them
SHARE_FOR_EACH = 1 / 3  # TaskBoard: of the work that is left, for each taker

parser = argparse.ArgumentParser()
parser.add_argument("report")
parser.add_argument("--latency", type=float, default=1e-3, help="of asking for a task; the post looks every millisecond")
parser.add_argument("--bandwidth", type=float, default=1e9)
parser.add_argument("--strips", type=float, default=0.12, help="share of a cut face's time that goes into its cuts")
parser.add_argument("--cutting", type=float, default=0.02, help="share that goes into finding its pieces")
parser.add_argument("--ranks", default="1,2,4,8,16,32,64,128,256,512")
options = parser.parse_args()

with open(options.report, encoding="utf-8") as file:
    report = json.load(file)
faces = [(face["seconds"], face["elements"]) for face in report["faces"]]
stages = report["seconds"]
elements = sum(count for _, count in faces)
in_faces = sum(seconds for seconds, _ in faces)
joining = max(0, stages["surface"] + stages["optimize"] - in_faces)  # joining, checks, further rounds


def pieces_of(count):
    """Halved again and again."""
    return 1 if count <= PIECE_ELEMENTS else 2 ** math.ceil(math.log2(count / PIECE_ELEMENTS))


class Face:
    def __init__(self, seconds, count):
        self.seconds, self.count, self.pieces = seconds, count, pieces_of(count)
        self.cutting = options.cutting * seconds if self.pieces > 1 else 0
        self.strips = options.strips * seconds if self.pieces > 1 else 0
        self.piece = (seconds - self.cutting - self.strips) / self.pieces

    def tail(self):
        """Strips are optimised by the owner alone."""
        return self.strips


def simulate(ranks):
    """Seconds until rank 0 has the meshes of all faces."""
    queue = sorted((Face(*face) for face in faces), key=lambda face: -face.seconds)
    left = in_faces
    free = [(0.0, rank) for rank in range(ranks)]
    heapq.heapify(free)
    cut = []  # [when it is cut, pieces that nobody has begun, face, when the last piece ends]
    inbox = 0.0  # until when rank 0 is busy with messages
    end = 0.0
    position = 0

    def arrive(time, count):
        nonlocal inbox, end
        cost = count * BYTES_OF_ELEMENT * (1 / options.bandwidth + 1 / COPY_BYTES_PER_SECOND)
        inbox = max(inbox, time) + (cost if ranks > 1 else 0)
        end = max(end, inbox)

    owners = {}
    while free:
        now, rank = heapq.heappop(free)
        now += options.latency if ranks > 1 else 0
        if rank in owners:  # it meshes pieces of its own face as long as there are any
            entry = owners[rank]
            if entry[1] > 0:
                entry[1] -= 1
                entry[3] = max(entry[3], now + entry[2].piece)
                heapq.heappush(free, (now + entry[2].piece, rank))
                continue
            finished = max(now, entry[3]) + entry[2].tail()
            del owners[rank]
            arrive(finished, entry[2].count)
            heapq.heappush(free, (finished, rank))
            continue
        if position < len(queue):
            share = SHARE_FOR_EACH * left / ranks
            taken, spent, count = 0, 0.0, 0
            while position < len(queue) and (taken == 0 or spent + queue[position].seconds <= share):
                face = queue[position]
                if face.pieces > 1 and taken > 0:
                    break
                position, taken = position + 1, taken + 1
                spent, count = spent + face.seconds, count + face.count
                if face.pieces > 1:
                    break
            left -= spent
            if face.pieces > 1 and taken == 1:
                entry = [now + face.cutting, face.pieces, face, 0.0]
                cut.append(entry)
                owners[rank] = entry
                heapq.heappush(free, (now + face.cutting, rank))
            else:
                arrive(now + spent, count)
                heapq.heappush(free, (now + spent, rank))
            continue
        open_regions = [entry for entry in cut if entry[1] > 0]
        if not open_regions:
            continue  # this rank has nothing to do any more
        entry = max(open_regions, key=lambda e: e[1])
        ready = max(now, entry[0]) + (0 if rank in entry[4:] else entry[2].cutting)
        entry[1] -= 1
        entry.append(rank)
        entry[3] = max(entry[3], ready + entry[2].piece)
        heapq.heappush(free, (ready + entry[2].piece, rank))
    return end


model_bytes = elements * 0 + 1e6
print(f"{elements} elements on {len(faces)} faces; seconds on one thread: read {stages['read']:.2f}, edges "
      f"{stages['edges']:.2f}, faces {in_faces:.2f}, joining and checks {joining:.2f}, writing {stages['write']:.2f}")
largest = max(Face(*face) for face in faces) if False else max((Face(*face) for face in faces), key=lambda f: f.seconds)
print(f"largest face {largest.seconds:.2f} s in {largest.pieces} piece(s) of {largest.piece:.2f} s")
print()
print("| ranks | faces, s | whole run, s | speed-up of faces | of the run |")
print("|---:|---:|---:|---:|---:|")
rest = stages["read"] + stages["edges"] + joining + stages["write"]
alone = None
for ranks in map(int, options.ranks.split(",")):
    sending = math.ceil(math.log2(ranks)) * (options.latency + model_bytes / options.bandwidth) if ranks > 1 else 0
    meshing = simulate(ranks)
    run = meshing + rest + sending
    alone = alone or (meshing, run)
    print(f"| {ranks} | {meshing:.3f} | {run:.2f} | {alone[0] / meshing:.1f} | {alone[1] / run:.1f} |")
