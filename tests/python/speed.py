# SPDX-License-Identifier: Apache-2.0
# Steps per second of the Python package on examples/tank, through numpy arrays.      speed.py
import time

import numpy as np

import smc

STEPS, RUNS = 2_000_000, 7

tank = smc.compile("examples/tank/tank.sm").machine(dt=10)
pressure = 600 + np.arange(STEPS) * 37 % 180.0
best_cpu = best_wall = float("inf")
for _ in range(RUNS):
    tank.reset()
    cpu, wall = time.process_time(), time.perf_counter()
    tank.run({"tankPressure": pressure})
    best_cpu = min(best_cpu, time.process_time() - cpu)
    best_wall = min(best_wall, time.perf_counter() - wall)
print(f"tank: {STEPS / best_cpu / 1e6:.1f} million steps in a second of CPU time, {STEPS / best_wall / 1e6:.1f} in a second of the clock (best of {RUNS})")
