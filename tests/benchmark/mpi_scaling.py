#!/usr/bin/env python3
"""mpi_scaling.py REPORT [--latency S] [--bandwidth B] [--strips SHARE] [--cutting SHARE] [--ranks N,N,...]

How long af2-mpi would take on many ranks, simulated from what a run on one thread has cost:

    af2 mesh MODEL --size S --threads 1 -q --stream -o mesh.msh2 --report REPORT

The simulation plays what geometry/mpi/crew does. Each rank reads and prepares the model; rank 0 divides the edges and sends
them through a tree. Whoever is free asks rank 0 for the next faces, the most work first; once all faces are begun,
those who are free take pieces of large faces, for which they begin and cut the face, too. The owner of a face waits
for its pieces and optimises along the cuts. Faces stay with those who have meshed them. Rank 0 is told what it needs to join
and check them, and gets each several times to measure and write the mesh."""

import argparse
import heapq
import json
import math

PIECE_ELEMENTS = 80000  # SplitOptions::pieceElements
BYTES_OF_ELEMENT = 1.4  # in what rank 0 is told of a face: its boundary, boxes for the checks
FETCHED_BYTES = 10 * 17.5  # for each element: so many times, its vertices, corners and rule in their packed form
SHARE = 1 / 3  # TaskBoard::nextTries
EDGES_BYTES = 1e6

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("report")
parser.add_argument("--latency", type=float, default=1e-3, help="until an answer of rank 0 has come, seconds")
parser.add_argument("--bandwidth", type=float, default=1e9, help="of the network at rank 0, bytes per second")
parser.add_argument("--strips", type=float, default=0.15, help="of the time of a cut face: optimising along cuts")
parser.add_argument("--cutting", type=float, default=0.02, help="of the time of a cut face: finding its pieces")
parser.add_argument("--ranks", default="1,2,4,8,16,32,64,128,256,512")
options = parser.parse_args()

with open(options.report, encoding="utf-8") as file:
    report = json.load(file)


class Face:
    def __init__(self, seconds, elements):
        self.seconds, self.elements = seconds, elements
        halvings = max(0, math.ceil(math.log2(max(1, elements) / PIECE_ELEMENTS)))
        self.pieces = 2**halvings
        self.cutting = options.cutting * seconds if self.is_cut() else 0
        self.strips = options.strips * seconds if self.is_cut() else 0
        self.piece = (seconds - self.cutting - self.strips) / self.pieces
        self.left = self.pieces  # that nobody has begun
        self.ready = self.done = 0.0  # when it is cut, and when its last piece is meshed
        self.helpers = set()

    def is_cut(self):
        return self.pieces > 1


class Simulation:
    def __init__(self, faces, ranks):
        self.queue = sorted(faces, key=lambda face: -face.seconds)
        self.work_left = sum(face.seconds for face in faces)
        self.ranks, self.next = ranks, 0
        self.inbox = self.end = 0.0  # until when rank 0 takes messages; when it has them all
        self.owned = {}  # by rank: the cut face that it has begun

    def run(self):
        """Seconds until rank 0 has the meshes of all faces."""
        free = [(0.0, rank) for rank in range(self.ranks)]
        while free:
            now, rank = heapq.heappop(free)
            until = self.give_task(now + (options.latency if self.ranks > 1 else 0), rank)
            if until is not None:
                heapq.heappush(free, (until, rank))
        return self.end

    def give_task(self, now, rank):
        if rank in self.owned:
            return self.go_on(now, rank, self.owned[rank])
        if self.next < len(self.queue):
            return self.mesh_faces(now, rank)
        cut = [face for face in self.queue if face.left > 0 and face.ready > 0]
        return self.help(now, rank, max(cut, key=lambda face: face.left)) if cut else None

    def mesh_faces(self, now, rank):
        face = self.queue[self.next]
        self.next += 1
        if face.is_cut():
            self.work_left -= face.seconds
            self.owned[rank] = face
            face.ready = now + face.cutting
            return face.ready
        seconds, elements, share = face.seconds, face.elements, SHARE * self.work_left / self.ranks
        while self.next < len(self.queue) and seconds + self.queue[self.next].seconds <= share:
            seconds += self.queue[self.next].seconds
            elements += self.queue[self.next].elements
            self.next += 1
        self.work_left -= seconds
        return self.send(now + seconds, elements)

    def go_on(self, now, rank, face):
        if face.left > 0:
            return self.mesh_piece(now, face)
        del self.owned[rank]
        return self.send(max(now, face.done) + face.strips, face.elements)

    def help(self, now, rank, face):
        begun = rank in face.helpers
        face.helpers.add(rank)
        return self.mesh_piece(max(now, face.ready) + (0 if begun else face.cutting), face)

    @staticmethod
    def mesh_piece(now, face):
        face.left -= 1
        face.done = max(face.done, now + face.piece)
        return now + face.piece

    def send(self, time, elements):
        if self.ranks > 1:
            self.inbox = max(self.inbox, time) + elements * BYTES_OF_ELEMENT / options.bandwidth
        self.end = max(self.end, self.inbox, time)
        return time


def faces():
    return [Face(face["seconds"], face["elements"]) for face in report["faces"]]


stages = report["seconds"]
in_faces = sum(face.seconds for face in faces())
joining = max(0, stages["surface"] + stages["optimize"] - in_faces)
largest = max(faces(), key=lambda face: face.seconds)
print(f"{sum(face.elements for face in faces()):,} elements on {len(faces())} faces. Seconds on one thread: reading "
      f"{stages['read']:.2f}, edges {stages['edges']:.2f}, faces {in_faces:.2f}, joining and checks {joining:.2f}, "
      f"writing {stages['write']:.2f}.")
print(f"The largest face takes {largest.seconds:.2f} s, in pieces of {largest.piece:.2f} s ({largest.pieces}).")
print("\n| ranks | faces, s | run, s | speed-up of the faces | of the run |\n|---:|---:|---:|---:|---:|")
rest = stages["read"] + stages["edges"] + joining + stages["write"]
fetching = sum(face.elements for face in faces()) * FETCHED_BYTES / options.bandwidth
alone = None
for ranks in map(int, options.ranks.split(",")):
    tree = math.ceil(math.log2(ranks)) * (options.latency + EDGES_BYTES / options.bandwidth)
    meshing = Simulation(faces(), ranks).run()
    run = meshing + rest + tree + fetching * (1 - 1 / ranks)
    alone = alone or (meshing, run)
    print(f"| {ranks} | {meshing:.2f} | {run:.2f} | {alone[0] / meshing:.1f} | {alone[1] / run:.1f} |")
