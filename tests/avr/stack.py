# SPDX-License-Identifier: Apache-2.0
"""The most stack that the firmware of a board can need, from its machine code.     stack.py OBJDUMP FIRMWARE.elf

Follows every path through the code, calls included, for any values, and adds up pushes, stack frames and return addresses.
Prints `N bytes of stack` and by whom: the deepest of all while no step begins; the deepest beside which one may; a step; the
interrupt that may come during one.  What it cannot follow ends it: recursion, a call through a pointer that CALLS does not know,
pushes in a loop, a stack pointer from nowhere.

An interrupt may come wherever they are allowed; a step allows them again, and then another may, up to where it would allow them
itself: there the firmware sees that a step is under way (`stepping` in firmware.c) and goes back.
"""
import collections
import re
import subprocess
import sys

# Who calls through a pointer, and whom.
CALLS = [
    ("answer_pin|smvm_runner_fits", "physical_pin_of|avr_physical_pin"),
    ("answer_end", "fits|smvm_runner_fits"),
    ("answer_hello|main", "may_update"),
    ("main", "answer_(pin|hello|image|begin|data|end|activate|confirm|erase|read|restart|events)"),
    ("answer_begin", "leave_slot"),
    ("write_memory|avr_eeprom_begin_write|main", "may_write"),
    ("authenticate|is_intact|answer_end|answer_confirm", "is_authentic"),     # called through Store.is_authentic
    (r"__vector_\d+", "on_tick"),
]
ROUNDS = {"divide": 7, "short": 7}       # who pushes in a loop, and how often: a division, each byte of its result
PAUSED = ("start_board", "run_image")    # in what these call no step begins (`is_paused` in firmware.c)

SKIPS = ("cpse", "sbrc", "sbrs", "sbic", "sbis")
READS = ("cp", "cpc", "cpi", "cpse", "push", "st", "std", "sts", "out", "sbrc", "sbrs")      # their first operand

Insn = collections.namedtuple("Insn", "at next name args target")
# At an instruction: bytes on the stack since the function began, those below the frame pointer Y (None: no frame), the phase, rounds.
State = collections.namedtuple("State", "at depth y phase rounds")
# Interrupts are forbidden from the beginning on; are again; are allowed.
CLOSED, MASKED, OPEN = range(3)
Need = collections.namedtuple("Need", "bytes chain")
Summary = collections.namedtuple("Summary", "deepest exits")          # of each phase; the phases that it returns in
NONE = Need(-1, ())


def number(text):
    return int(text, 0)


def signed(low, high):
    return (low | high << 8) - (0x10000 if high & 0x80 else 0)


# ---- the code ----

class Code:
    def __init__(self, objdump, path):
        self.insns, self.names, self.functions = {}, {}, {}
        name = ""
        for line in subprocess.run([objdump, "-d", path], check=True, capture_output=True, text=True).stdout.splitlines():
            if m := re.match(r"([0-9a-f]+) <(.*)>:", line):
                name = re.sub(r"\.(lto_priv|constprop|part|isra)\.\d+", "", m[2])
                self.functions.setdefault(int(m[1], 16), name)
            elif m := re.match(r"\s*([0-9a-f]+):\t((?:[0-9a-f]{2} )+)\s*\t(\S+)\s*([^;]*?)\s*(?:; (?:0x([0-9a-f]+))?.*)?$", line):
                self.take(int(m[1], 16), len(m[2].split()), m[3], m[4], m[5], name)
        self.address = 3 if any(i.name == "eijmp" for i in self.insns.values()) else 2         # bytes of a return address

    def take(self, at, size, name, args, target, function):
        goes = name in ("call", "jmp", "rcall", "rjmp") or name.startswith("br")
        self.insns[at] = Insn(at, at + size, name, [a.strip() for a in args.split(",")], int(target, 16) if goes and target else None)
        self.names[at] = function

    def before(self, insn, n):
        found = []
        for _ in range(n):
            insn = next(i for i in (self.insns.get(insn.at - 2), self.insns.get(insn.at - 4)) if i and i.next == insn.at)
            found.append(insn)
        return found

    def called(self, insn):
        """Where this call through a pointer may go."""
        caller = self.names[insn.at]
        itself = max(at for at in self.functions if at <= insn.at)
        wanted = "|".join(callee for pattern, callee in CALLS if re.fullmatch(pattern, caller))
        found = {at for at, name in self.functions.items() if at != itself and re.fullmatch(wanted, name)}
        if caller == "keeping_z":                      # number_avr.S: the function's address was put into X
            found = self.soft_operations()
        if not found:
            sys.exit(f"{caller} calls through a pointer: whom?")
        return found

    def soft_operations(self):
        found = set()
        for low in self.insns.values():
            high = self.insns.get(low.next)
            if low.name == "ldi" and low.args[0] == "r26" and high and high.name == "ldi" and high.args[0] == "r27":
                at = 2 * (number(high.args[1]) << 8 | number(low.args[1]))
                found |= {at} if self.functions.get(at, "").startswith("sm_soft_") else set()
        return found


# ---- the paths through it ----

class Walk:
    def __init__(self, code, without=()):
        self.code, self.without = code, without
        self.known, self.under_way = {}, []

    def function(self, at, phase):
        """What a call of it needs, its return address not counted."""
        if at in self.under_way:
            sys.exit("recursion: " + " ".join(self.code.names[a] for a in self.under_way + [at]))
        if (at, phase) not in self.known:
            self.under_way.append(at)
            self.known[at, phase] = Ways(self, at).explore(phase)
            self.under_way.pop()
        return self.known[at, phase]


class Ways:
    """Those through one function."""

    def __init__(self, walk, entry):
        self.walk, self.code, self.entry, self.name = walk, walk.code, entry, walk.code.names[entry]
        self.deepest, self.exits = [NONE] * 3, set()

    def explore(self, phase):
        seen = collections.Counter()
        work, known = [State(self.entry, 0, None, phase, 0)], set()
        while work:
            s = work.pop()
            if s in known:
                continue
            known.add(s)
            seen[s.at] += 1
            if seen[s.at] > 40:
                sys.exit(f"{self.name}: pushes in a loop at {s.at:x}")
            self.note(s.phase, s.depth, ())
            work += self.after(s, self.code.insns[s.at])
        return Summary(self.deepest, self.exits)

    def note(self, phase, depth, chain):
        if depth > self.deepest[phase].bytes:
            self.deepest[phase] = Need(depth, (self.name,) + chain)

    def after(self, s, insn):
        """The states that may follow."""
        name, on = insn.name, s._replace(at=insn.next)
        if name in ("ret", "reti"):
            self.exits.add(s.phase)
            return []
        if name in ("rjmp", "jmp"):
            return self.jump(s, insn)
        if name in ("call", "rcall", "icall", "eicall"):
            return [on._replace(depth=s.depth + self.code.address)] if insn.target == insn.next else self.call(on, insn)
        if name in ("ijmp", "eijmp"):
            sys.exit(f"{self.name} jumps through a pointer at {s.at:x}")
        if name.startswith("br") and insn.target is not None:
            return [on, s._replace(at=insn.target)]
        if name in SKIPS:
            return [on, s._replace(at=self.code.insns[insn.next].next)]
        return self.change(on, insn)

    def jump(self, s, insn):
        to = self.code.names[insn.target]
        if to == "__epilogue_restores__":              # libgcc's end of a function
            self.exits.add(s.phase)
            return []
        if to == "__prologue_saves__":
            return [self.prologue(s, insn)]
        return [] if insn.target == 0 else [s._replace(at=insn.target)]        # 0: a restart

    def prologue(self, s, insn):
        """libgcc's beginning: registers from the place where it is entered on, and a frame of X bytes; it goes on at Z."""
        value = {i.args[0]: number(i.args[1]) for i in self.code.before(insn, 4)}
        start = min(at for at, name in self.code.names.items() if name == "__prologue_saves__")
        depth = s.depth + 18 - (insn.target - start) // 2 + signed(value["r26"], value["r27"])
        return State(2 * (value["r31"] << 8 | value["r30"]), depth, depth, s.phase, s.rounds)

    def call(self, on, insn):
        exits = set()
        for target in [insn.target] if insn.target is not None else self.code.called(insn):
            callee = self.walk.function(target, on.phase)
            exits |= callee.exits
            for phase, need in enumerate(callee.deepest):
                if need.bytes >= 0 and self.name not in self.walk.without:
                    self.note(phase, on.depth + self.code.address + need.bytes, need.chain)
        return [on._replace(phase=phase) for phase in exits]

    def change(self, on, insn):
        """Of the stack, of Y, of whether interrupts are allowed."""
        name, first = insn.name, insn.args[0]
        if name == "push":
            rounds = on.rounds + (self.code.names[insn.at] in ROUNDS)
            return [on._replace(depth=on.depth + 1, rounds=rounds)] if rounds <= ROUNDS.get(self.code.names[insn.at], rounds) else []
        if name == "pop":
            on = on._replace(depth=on.depth - 1)
        if name in ("sei", "cli"):
            return [on._replace(phase=OPEN if name == "sei" else min(on.phase, MASKED))]
        if name == "out" and first == "0x3f":          # SREG as it was before a cli
            return [on._replace(phase=OPEN if on.phase == MASKED else on.phase)]
        if name == "out" and first == "0x3d":
            return [on._replace(depth=self.frame(on, insn))]
        return [on._replace(y=self.y_after(on, insn))] if first == "r28" and name not in READS else [on]

    def frame(self, on, insn):
        if on.y is None and insn.at > 0 and self.entry != 0:
            sys.exit(f"{self.name}: a stack pointer from nowhere at {insn.at:x}")
        return on.y or 0

    def y_after(self, on, insn):
        if insn.name == "in" and insn.args[1] == "0x3d":
            return on.depth
        if on.y is not None and insn.name in ("sbiw", "adiw"):
            return on.y + (number(insn.args[1]) if insn.name == "sbiw" else -number(insn.args[1]))
        if on.y is not None and insn.name == "subi":   # and sbci of r29 behind it, or sbc of 0
            high = self.code.insns[insn.next].args[1]
            return on.y + signed(number(insn.args[1]), 0 if high == "r1" else number(high))
        return None


# ---- all together ----

def deepest(needs):
    return max(needs, key=lambda n: n.bytes)


def main():
    code = Code(sys.argv[1], sys.argv[2])
    held = deepest(Walk(code).function(0, CLOSED).deepest)
    beside = Walk(code, PAUSED).function(0, CLOSED).deepest[OPEN]
    vectors = [Walk(code).function(at, CLOSED).deepest for at, name in code.functions.items() if name.startswith("__vector_")]
    step = deepest(n for v in vectors for n in v)
    short = deepest(v[CLOSED] for v in vectors)
    most = max(held.bytes + code.address + short.bytes, beside.bytes + 2 * code.address + step.bytes + short.bytes)
    print(f"{most} bytes of stack")
    for need in (held, beside, step, short):
        print(f"{need.bytes:6}  {' '.join(need.chain)}")


main()
