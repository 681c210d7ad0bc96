"""Meshes a part of a STEP file with smaller elements where it is curved, and writes files for ParaView and a browser.

Run it in the folder of the repository: PYTHONPATH=build/python /usr/bin/python3 examples/python/mesh_a_part.py

Writes: die.vtu, die.html
"""

import os
import pathlib

import af2

MODELS = pathlib.Path(os.environ.get("AF2_MODELS", "examples/models"))

model = af2.read(MODELS / "die.step")
for face in model.parts().faces[:3]:
    print(f"face {face.id}: {face.surface}, area {face.area:.3g}")

mesh = af2.mesh(model, size=1, curvature=24, min_size=0.1)
print(mesh)
print(f"smallest angle {mesh.measures.min_angle:.1f} degrees, {mesh.measures.free_edges} free edges")

worst = mesh.quality.argmin()
print(f"worst element: {mesh.quality[worst]:.2f}, on face {mesh.face[worst]}, by rule '{mesh.rule_names[mesh.rule[worst]]}'")

mesh.write("die.vtu")
mesh.write("die.html")
