# SPDX-License-Identifier: BSD-3-Clause
"""The wet packing under YADE: Willett's analytic force in ViscElCap, one volume for all bridges, six plane walls.

The numbers are those of scenes.hpp. Run by yade -x; from the environment: DATA (a LAMMPS data file), REACH (m, pairs
closer than this get a bridge), VOLUME (m3), SKIN (m), WARMUP, STEPS. Prints, per grain: ns of the processor per step,
bridges, contacts, kinetic energy."""
import math
import os
import time

from yade import utils
from yade.wrapper import *

stiffness, damping, density = 1000, 0.8, 2700
reach, volume, skin = (float(os.environ[name]) for name in ("REACH", "VOLUME", "SKIN"))
warmup, steps = (int(os.environ[name]) for name in ("WARMUP", "STEPS"))


def material(wet, mass):
    # Two of these in series make the stiffness and the dashpot of the pair.
    return ViscElCapMat(kn=2 * stiffness, ks=2 * 0.8 * stiffness, cn=4 * damping * math.sqrt(mass / 2 * stiffness),
                        cs=0, frictionAngle=math.atan(0.4), density=density, Capillar=wet, Vb=volume, gamma=0.0637,
                        theta=0, dcap=0, CapillarType="Willett_analytic")


grains, size = [], []
with open(os.environ["DATA"]) as data:
    for words in map(str.split, data):
        if len(words) == 4 and words[2] in ("xlo", "ylo", "zlo"):
            size.append(float(words[1]))
        if len(words) == 7:
            grains.append((float(words[2]) / 2, [float(x) for x in words[4:]]))
mean_mass = sum(4 / 3 * math.pi * r**3 * density for r, _ in grains) / len(grains)
O.materials.append(material(True, mean_mass))
O.materials.append(material(False, mean_mass))
O.bodies.append([utils.sphere(x, r, material=0) for r, x in grains])
for axis in range(3):
    O.bodies.append(utils.wall(0, axis=axis, sense=1, material=1))
    O.bodies.append(utils.wall(size[axis], axis=axis, sense=-1, material=1))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=skin),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                    [Ip2_ViscElCapMat_ViscElCapMat_ViscElCapPhys()], [Law2_ScGeom_ViscElCapPhys_Basic()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
# Bridges form on touch only: one step without time with grains that reach each other.
O.dt = 1e-20
for body, (radius, _) in zip(O.bodies, grains):
    body.shape.radius = radius + reach / 2
O.step()
for body, (radius, _) in zip(O.bodies, grains):
    body.shape.radius = radius
O.dt = 1e-6
O.run(warmup, True)
began = time.process_time()
O.run(steps, True)
elapsed = time.process_time() - began
between = [i for i in O.interactions if i.isReal and max(i.id1, i.id2) < len(grains)]
bridges = sum(1 for i in between if i.phys.liqBridgeCreated)
contacts = sum(1 for i in between if i.geom.penetrationDepth > 0)
energy = sum(0.5 * body.state.mass * body.state.vel.squaredNorm() for body, _ in zip(O.bodies, grains))
print("%.17g ns per grain and step, bridges %.17g, contacts %.17g, kinetic energy %.17g J" %
      (1e9 * elapsed / steps / len(grains), bridges / len(grains), contacts / len(grains), energy / len(grains)),
      flush=True)
os._exit(0)
