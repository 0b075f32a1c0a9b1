# The same as data; without a script.
args report a.sm --format=json

-- a.sm --
[state_vector]
U64 G
U32 S
bool valve    # lets "fuel" in
[Idle]
.step
    valve = not valve
    T > 1000: -> Done
[Done]
-- stdout --
{"smc-report": 1, "machine": "a",
 "overview": {"title": "Overview",
   "text": [
    "Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided. Failed: something is shown to be wrong.",
    "Not examined: changes that no script notices (`--mutate`), faults of sensors (`--faults`), margins of parameters (`--sweep`). `smc report --all` adds them.",
    "The machine has 2 states and starts in `Idle`. It writes `valve`. It never leaves `Done`."],
   "tables": {
    "verdicts": [
      {"section": "Findings", "verdict": "open", "details": "1 open"},
      {"section": "Scripts", "verdict": "open", "details": "none were run"},
      {"section": "Longest step", "verdict": "", "details": "7 instructions, in Idle"}
    ],
    "blockers": [
      {"what": "1 open finding", "how": "W0920 (Findings)"}
    ],
    "facts": {
      "States": "2",
      "Transitions": "1",
      "Findings": "1",
      "Scripts": "none were run",
      "Longest step": "7 instructions, in Idle",
      "On an Arduino Uno": "about 2156 cycles, 0.14 ms, in Idle",
      "Memory on the VM": "96 bytes on a 64-bit computer",
      "Image": "86 bytes",
      "Image CRC": "ced101b8",
      "Source identity": "fdba2cfd5231c29c",
      "State vector": "declared in the machine"
    }}},
 "outputs": {"title": "Outputs in each state",
   "text": [
    "What each output is after a step in which the machine stays in the state. Several values: which one depends on conditions or on the path to the state. An expression: the step computes the output from it; parts that the state decides are left out. \"Computed\": from more than fits here, or in an earlier step. \"Unchanged\": the state does not assign it, so it is what earlier states have left. \"Initial\": no state has assigned it yet. Other machines, or a `[start]`, can set other values."],
   "tables": {
    "outputs": [
      {"state": "Idle", "mark": "", "valve": "`not valve`"},
      {"state": "Done", "mark": "", "valve": "unchanged: computed"}
    ]}},
 "states": {"title": "States",
   "text": [
    "The machine runs in steps. In each step it executes the statements of its state from top to bottom, also in the step in which it enters the state. The first transition whose condition is true is taken, and the statements after it are skipped. The next step runs the state to which the transition leads. `T` is the time since the machine entered the state, `G` is the time.",
    "This state has no statements: the machine does nothing and stays.",
    "Entered from `Idle`."],
   "lists": {
    "Idle.step": [
      {"depth": 0, "line": 7, "text": "sets `valve` to `not valve`"},
      {"depth": 0, "line": 8, "text": "goes to `Done` if `T > 1000`"}
    ]}},
 "transitions": {"title": "Transitions",
   "text": [
    "In the order of the file, which is their priority: if several can be taken in one step, the machine takes the first of them."],
   "tables": {
    "transitions": [
      {"number": 1, "from": "Idle", "to": "Done", "when": "T > 1000", "block": ".step", "line": 8, "note": "", "comment": ""}
    ]}},
 "variables": {"title": "Inputs, outputs and parameters",
   "tables": {
    "elements": [
      {"name": "G", "type": "U64", "unit": "", "role": "time", "range": "", "comment": "", "read": "", "written": ""},
      {"name": "S", "type": "U32", "unit": "", "role": "state number", "range": "", "comment": "", "read": "", "written": ""},
      {"name": "valve", "type": "bool", "unit": "", "role": "output, read back", "range": "", "comment": "lets \"fuel\" in", "read": "Idle", "written": "Idle"}
    ]}},
 "findings": {"title": "Findings",
   "text": [
    "Findings of all groups of warnings. `smc explain` with a name or code prints what a finding means and what to do. The time per step is unknown. With `--step` the analyses find more."],
   "tables": {
    "findings": [
      {"number": 1, "name": "missing-way-out", "group": "-Wflight", "position": "a.sm:9:2", "message": "the machine can never leave 'Done'", "code": "W0920"}
    ]}},
 "abort": {"title": "Abort matrix",
   "text": [
    "No state is marked `@abort`, so the report cannot show how this machine aborts. Put the mark after the header of the state that handles failures, as in `[Abort] @abort`."]},
 "scripts": {"title": "Scripts",
   "text": [
    "No script was run. Name scripts after the machine, as in `smc report tank.sm tank.ss`."]},
 "cost": {"title": "Costs",
   "text": [
    "VM instructions in the longest step of each state, computed from the image that flies. No step can take more. The first step of a state also runs `.entry`, and a step that leaves the state also runs `.exit`. The cycles are those of the step that takes most cycles, which can be another step than the one with most instructions.",
    "The longest step at 16 MHz. This is an estimate: for each instruction it assumes the highest cost that was measured on an ATmega328P, for any operands. In tests, real steps took between a third and three quarters of the estimate. It is not proved that no step can take longer. The cost of emitted C depends on the compiler and is not estimated.",
    "RAM of this machine on the VM of a 64-bit computer. A board with shorter pointers needs slightly less. The state vector is shared with the application and is not included."],
   "tables": {
    "steps": [
      {"state": "Idle", "first": 7, "later": 7, "lines": "line 7: 4, line 8: 3", "cycles": 2156},
      {"state": "Done", "first": 0, "later": 0, "lines": "", "cycles": 732}
    ],
    "longest": [
      {"block": ".step", "line": 7, "text": "valve = not valve", "instructions": 4},
      {"block": ".step", "line": 8, "text": "T > 1000: -> Done", "instructions": 3}
    ],
    "board": [
      {"part": "Longest step, image in EEPROM", "value": "2156 cycles, 0.14 ms, in Idle"},
      {"part": "Longest step, image in flash", "value": "1702 cycles, 0.11 ms, in Idle"},
      {"part": "Stack of a step, largest measured", "value": "319 bytes"},
      {"part": "RAM of state vector, locals and windows", "value": "16 bytes of at most 960"},
      {"part": "Image", "value": "86 bytes of at most 960"}
    ],
    "bytes": [
      {"part": "Windows of rolling statistics", "bytes": 0},
      {"part": "Locals and temporary values", "bytes": 0},
      {"part": "State of the VM", "bytes": 96},
      {"part": "RAM in total", "bytes": 96},
      {"part": "State vector", "bytes": 16},
      {"part": "Image, in flash or RAM", "bytes": 86},
      {"part": "of which code", "bytes": 16}
    ]}}
}
