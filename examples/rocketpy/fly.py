# SPDX-License-Identifier: Apache-2.0
"""Dual deployment flown in RocketPy: the machine of examples/parachutes controls a simulated rocket, and its altimeter fails.

    fly.py [--flights 100] [--seed 1] [--cc cc] -o FOLDER

Each flight has its own motor, mass, drag, wind, rail and parachutes, and one of five altimeters: healthy, stuck, dead, nan, late.  The machine is
stepped at 100 Hz with what the altimeter measures, and RocketPy opens a parachute when the machine fires its charge.  Afterwards each flight is
run again by the VM on arrays and by the C that smc emits: the outputs and the state must be equal in every tick.
"""
from __future__ import annotations

import argparse
import csv
import subprocess
import sys
from collections import deque
from dataclasses import dataclass, field
from pathlib import Path

import cffi
import numpy as np
from rocketpy import Environment, Flight, GenericMotor, Rocket
from rocketpy.control.controller import _Controller

import smc

RATE = 100                        # steps in a second
DT = 1000 // RATE                 # ms: by how much G advances in a step
FAILURES = ("healthy", "stuck", "dead", "nan", "late")
MACHINE = Path(__file__).resolve().parent.parent / "parachutes/parachutes.sm"


# ---- the altimeter ----


class Altimeter:
    """Noise, a wild sample now and then, and from `fails_at` (s) on one of FAILURES."""

    def __init__(self, failure: str, random: np.random.Generator) -> None:
        self.failure = failure
        self.fails_at = random.uniform(0.5, 45)
        self.delay = random.uniform(0.3, 2)       # s, of the failure "late"
        self.random = random
        self.samples: deque[float] = deque(maxlen=1 + int(self.delay * RATE))
        self.last = 0.0

    def measure(self, time: float, altitude: float) -> float:
        sample = altitude + self.random.normal(0, 1)
        if self.random.random() < 0.002:
            sample = self.random.uniform(-500, 3000)
        self.samples.append(sample)
        if self.failure == "healthy" or time < self.fails_at:
            self.last = sample
        elif self.failure == "dead":
            self.last = 0.0
        elif self.failure == "nan":
            self.last = float("nan")
        elif self.failure == "late":
            self.last = self.samples[0]
        return float(np.float32(self.last))       # the element is an F32


# ---- a flight ----


@dataclass
class Log:
    """What the machine read and did in each tick."""

    g: list[int] = field(default_factory=list)
    altitude: list[float] = field(default_factory=list)
    outputs: list[int] = field(default_factory=list)
    states: list[int] = field(default_factory=list)


@dataclass
class Result:
    number: int
    failure: str
    fails_at: float               # s; nan if it does not
    apogee: float                 # m
    apogee_time: float            # s
    drogue_delay: float           # s after apogee; nan if it did not open
    drogue_speed: float           # m/s when it opened
    main_altitude: float          # m when it opened
    landing_speed: float          # m/s
    outcome: str
    track: tuple[np.ndarray, np.ndarray]
    log: Log


class Computer:
    """The flight computer: steps the machine, and remembers which charges have been fired."""

    def __init__(self, machine: smc.Machine, altimeter: Altimeter, elevation: float) -> None:
        self.machine = machine
        self.altimeter = altimeter
        self.elevation = elevation
        self.log = Log()
        self.state_number = {name: 1 + i for i, name in enumerate(machine.states)}
        self.has_fired = {"drogue": False, "main": False}

    def tick(self, time, rate, state, history, observed, objects, sensors, environment) -> None:
        """A controller of RocketPy.  A phase of its integration can begin with the tick with which the last one ended."""
        g = round(time * RATE) * DT
        if self.log.g and g <= self.log.g[-1]:
            return
        altitude = self.altimeter.measure(time, state[2] - self.elevation)
        after = self.machine.step(g, altitude=altitude)
        self.has_fired["drogue"] |= bool(after.drogueCharge)
        self.has_fired["main"] |= bool(after.mainCharge)
        self.log.g.append(g)
        self.log.altitude.append(altitude)
        self.log.outputs.append(after.drogueCharge | after.mainCharge << 1 | after.beacon << 2)
        self.log.states.append(self.state_number[self.machine.state])

    def trigger(self, name: str):
        return lambda pressure, height, state: self.has_fired[name]


def build_rocket(random: np.random.Generator, computer: Computer) -> Rocket:
    thrust = random.normal(1, 0.04)
    motor = GenericMotor(
        thrust_source=[[0, 0], [0.05, 420 * thrust], [2.2, 380 * thrust], [2.5, 0]], burn_time=2.5,
        chamber_radius=0.027, chamber_height=0.3, chamber_position=0.17, propellant_initial_mass=0.45, nozzle_radius=0.02,
        dry_mass=0.4, center_of_dry_mass_position=0.17, dry_inertia=(0.005, 0.005, 0.0002),
    )  # fmt: skip
    drag = random.normal(0.5, 0.03)
    rocket = Rocket(
        radius=0.049, mass=random.normal(5.5, 0.08), inertia=(0.6, 0.6, 0.01), power_off_drag=drag, power_on_drag=drag,
        center_of_mass_without_motor=0.9, coordinate_system_orientation="tail_to_nose",
    )  # fmt: skip
    rocket.add_motor(motor, position=0)
    rocket.add_nose(length=0.3, kind="ogive", position=1.7)
    rocket.add_trapezoidal_fins(4, root_chord=0.15, tip_chord=0.08, span=0.12, position=0.18)
    rocket._add_controllers([_Controller([], computer.tick, RATE)])
    for name, area in (("drogue", 0.35), ("main", 2.6)):
        rocket.add_parachute(name, cd_s=area * random.normal(1, 0.05), trigger=computer.trigger(name), sampling_rate=RATE)
    return rocket


def judge(drogue_delay: float, main_altitude: float, landing_speed: float) -> str:
    if landing_speed > 9:
        return "crash"
    if drogue_delay < -0.5:
        return "drogue early"
    if not drogue_delay < 2:
        return "drogue late"
    if main_altitude > 300:
        return "main high"
    if main_altitude < 200:
        return "main low"
    return "as planned"


def fly(number: int, seed: int, machine: smc.Machine) -> Result:
    random = np.random.default_rng([seed, number])
    altimeter = Altimeter(FAILURES[number % len(FAILURES)], random)
    machine.reset()
    environment = Environment(elevation=0)
    wind = random.normal(0, 4)
    environment.set_atmospheric_model("custom_atmosphere", wind_u=wind, wind_v=random.normal(0, 1))
    computer = Computer(machine, altimeter, environment.elevation)
    rocket = build_rocket(random, computer)
    flight = Flight(rocket=rocket, environment=environment, rail_length=3, inclination=random.normal(86, 1), heading=random.uniform(0, 360), max_time=300)

    opened = {parachute.name: time for time, parachute in flight.parachute_events}
    drogue, main = opened.get("drogue", float("nan")), opened.get("main", float("nan"))
    height = lambda t: float(flight.z(t)) - environment.elevation if t == t else float("nan")  # noqa: E731
    delay, main_altitude, landing = drogue - flight.apogee_time, height(main), abs(float(flight.impact_velocity))
    time = np.array([row[0] for row in flight.solution])
    return Result(
        number=number, failure=altimeter.failure, fails_at=float("nan") if altimeter.failure == "healthy" else altimeter.fails_at,
        apogee=flight.apogee - environment.elevation, apogee_time=flight.apogee_time, drogue_delay=delay,
        drogue_speed=float(flight.speed(drogue)) if drogue == drogue else float("nan"), main_altitude=main_altitude, landing_speed=landing,
        outcome=judge(delay, main_altitude, landing), track=(time, np.array([row[3] for row in flight.solution]) - environment.elevation), log=computer.log,
    )  # fmt: skip


# ---- the same flight on other engines ----


class EmittedC:
    """The C that smc emits for the machine, compiled into a shared library."""

    def __init__(self, program: smc.Program, cc: str, folder: Path) -> None:
        for name, contents in program.emit("c").items():
            (folder / name).write_bytes(contents)
        library = folder / "parachutes.so"
        sources = [str(folder / "parachutes.c"), str(Path(__file__).resolve().parent / "columns.c")]
        subprocess.run([*cc.split(), "-std=c99", "-O2", "-ffp-contract=off", "-fPIC", "-shared", f"-I{folder}", "-o", str(library), *sources], check=True)
        self.ffi = cffi.FFI()
        self.ffi.cdef("uint64_t fly_columns(uint64_t rows, const uint64_t *g, const float *altitude, uint8_t *outputs, uint32_t *states);")
        self.library = self.ffi.dlopen(str(library))

    def run(self, g: np.ndarray, altitude: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        altitude = altitude.astype(np.float32)
        outputs, states = np.zeros(len(g), np.uint8), np.zeros(len(g), np.uint32)
        pointer = self.ffi.from_buffer
        done = self.library.fly_columns(len(g), pointer("uint64_t[]", g), pointer("float[]", altitude), pointer("uint8_t[]", outputs), pointer("uint32_t[]", states))
        assert done == len(g), f"emitted C ended after {done} of {len(g)} steps"
        return outputs, states


def run_on_vm(machine: smc.Machine, g: np.ndarray, altitude: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    machine.reset()
    run = machine.run({"altitude": altitude}, g=g, record=["drogueCharge", "mainCharge", "beacon"])
    return run["drogueCharge"] + 2 * run["mainCharge"] + 4 * run["beacon"].astype(np.uint8), run.state


def count_differences(log: Log, machine: smc.Machine, emitted: EmittedC) -> int:
    """Ticks in which the flight, the VM on arrays and emitted C do not agree."""
    g, altitude = np.array(log.g, np.uint64), np.array(log.altitude)
    flown = (np.array(log.outputs), np.array(log.states))
    differs = np.zeros(len(g), bool)
    for outputs, states in (run_on_vm(machine, g, altitude), emitted.run(g, altitude)):
        differs |= (outputs != flown[0]) | (states != flown[1])
    return int(differs.sum())


# ---- the table and the plot ----


def write_table(results: list[Result], file) -> None:
    outcomes = ("as planned", "drogue early", "drogue late", "main high", "main low", "crash")
    print(f"{'altimeter':10}{'flights':>8}" + "".join(f"{o:>14}" for o in outcomes) + f"{'drogue late by':>17}{'its speed':>12}{'main at':>14}{'landing':>14}", file=file)
    for failure in FAILURES:
        own = [r for r in results if r.failure == failure]
        if not own:
            continue
        column = lambda name: np.array([getattr(r, name) for r in own])  # noqa: E731
        counts = "".join(f"{sum(r.outcome == o for r in own):>14}" for o in outcomes)
        main = column("main_altitude")
        main_range = f"{np.nanmin(main):.0f} to {np.nanmax(main):.0f} m" if np.isfinite(main).any() else "never"
        print(
            f"{failure:10}{len(own):>8}{counts}{np.nanmax(column('drogue_delay')):>15.1f} s{np.nanmax(column('drogue_speed')):>8.0f} m/s{main_range:>14}"
            f"{np.max(column('landing_speed')):>10.1f} m/s",
            file=file,
        )  # fmt: skip


def write_csv(results: list[Result], path: Path) -> None:
    columns = ("number", "failure", "fails_at", "apogee", "apogee_time", "drogue_delay", "drogue_speed", "main_altitude", "landing_speed", "outcome")
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        for r in results:
            writer.writerow([f"{v:.3f}" if isinstance(v, float) else v for v in (getattr(r, c) for c in columns)])


def draw(results: list[Result], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plot

    figure, axes = plot.subplots(1, len(FAILURES), figsize=(16, 4), sharey=True)
    for axis, failure in zip(axes, FAILURES):
        own = [r for r in results if r.failure == failure]
        for r in own:
            axis.plot(*r.track, color="C3" if r.outcome == "crash" else "C0", linewidth=0.7, alpha=0.6)
            for time, mark in ((r.apogee_time + r.drogue_delay, "v"), (_time_of(r.log, 2), "o")):
                if time == time:
                    axis.plot(time, np.interp(time, *r.track), mark, color="black", markersize=3)
        axis.set_title(f"{failure}: {sum(r.outcome == 'as planned' for r in own)} of {len(own)} as planned", fontsize="medium")
        axis.set_xlabel("s")
    axes[0].set_ylabel("m above the pad")
    figure.suptitle("drogue (triangle) and main (dot) by the state of the altimeter; red: crash", fontsize="medium")
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def _time_of(log: Log, bit: int) -> float:
    fired = np.flatnonzero(np.array(log.outputs) & bit)
    return log.g[fired[0]] / 1000 if len(fired) else float("nan")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--flights", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cc", default="cc")
    parser.add_argument("-o", dest="folder", type=Path, required=True)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)

    with smc.compile(MACHINE) as program:
        emitted = EmittedC(program, options.cc, options.folder)
        flying, replaying = program.machine(dt=DT), program.machine(dt=DT)
        results, ticks, different = [], 0, 0
        for number in range(options.flights):
            results.append(fly(number, options.seed, flying))
            ticks += len(results[-1].log.g)
            different += count_differences(results[-1].log, replaying, emitted)
            print(f"\r{number + 1} of {options.flights} flights", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    with (options.folder / "flights.txt").open("w") as file:
        for to in (file, sys.stdout):
            write_table(results, to)
            print(f"{ticks} ticks: the flight in Python, the VM on arrays and emitted C differ in {different}", file=to)
    write_csv(results, options.folder / "flights.csv")
    draw(results, options.folder / "flights.png")
    return 1 if different or not ticks else 0


if __name__ == "__main__":
    sys.exit(main())
