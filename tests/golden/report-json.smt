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
 "overview": {"title": "At a glance",
   "text": [
    "The machine has 2 states and begins in `Idle`. It drives `valve`. Once in `Done`, it stays there."],
   "tables": {
    "facts": {
      "States": "2",
      "Transitions": "1",
      "Findings": [..],
      "Scripts": "none were run",
      "Longest step": "7 instructions, in Idle",
      "On an Arduino Uno": "about [..] ms",
      "Memory on the VM": "56 bytes on a 64-bit computer",
      "Image": "86 bytes",
      "Image CRC": "ced101b8",
      "Source identity": "fdba2cfd5231c29c",
      "State vector": "the machine's own"
    }}},
 "states": {"title": "What it does in each state",
   "text": [
    "The machine is run again and again; each time is a step. What stands under \"at each step\" is done from top to bottom, in the step in which the machine enters too. The first way out whose condition holds is taken, and nothing behind it is done any more; the state it leads to begins with the next step. `T` is the time since the state began, `G` the time.",
    "In this state the machine does nothing, and stays.",
    "Entered from `Idle`."],
   "lists": {
    "Idle.step": [
      {"depth": 0, "line": 7, "text": "sets `valve` to `not valve`"},
      {"depth": 0, "line": 8, "text": "leaves for `Done` if `T > 1000`"}
    ]}},
 "transitions": {"title": "Transitions",
   "text": [
    "In the order of the file. Of two that could be made in one step, the upper one is made."],
   "tables": {
    "transitions": [
      {"number": 1, "from": "Idle", "to": "Done", "when": "T > 1000", "block": ".step", "line": 8, "note": "", "comment": ""}
    ]}},
 "variables": {"title": "Inputs, outputs and parameters",
   "tables": {
    "elements": [
      {"name": "G", "type": "U64", "role": "time", "range": "", "comment": "", "read": "", "written": ""},
      {"name": "S", "type": "U32", "role": "number of the state", "range": "", "comment": "", "read": "", "written": ""},
      {"name": "valve", "type": "bool", "role": "output, read back", "range": "", "comment": "lets \"fuel\" in", "read": "Idle", "written": "Idle"}
    ]}},
...
 "abort": {"title": "Abort matrix",
   "text": [
    "No state is marked `@abort`, so nothing can be said about how this machine aborts. Write the mark behind the header of the state where it goes when something is wrong, as in `[Abort] @abort`."]},
 "cost": {"title": "What it costs",
   "text": [
    "Instructions of the VM in the longest step of each state, found on the very image that flies; no step can take more. The first step of a state runs `.entry` too, and a step that leaves runs `.exit`.",
    "What the worst step takes on an ATmega328P at 16 MHz. It is an estimate: of each instruction the most that was seen in measurements counts, whatever numbers it works on. Real steps take less, a third to three quarters of it in tests; that none can take more is not proved. What emitted C takes there depends on its compiler and is not estimated.",
    "RAM of this machine on the VM of a computer with pointers of 64 bits; a board with shorter ones needs a little less. The state vector, which the application shares, comes on top."],
   "tables": {
    "steps": [
      {"state": "Idle", "first": 7, "later": 7, "dearest": "line 7: 4, line 8: 3", "cycles": [..]},
      {"state": "Done", "first": 0, "later": 0, "dearest": "", "cycles": [..]}
    ],
    "longest": [
      {"block": ".step", "line": 7, "text": "valve = not valve", "instructions": 4},
      {"block": ".step", "line": 8, "text": "T > 1000: -> Done", "instructions": 3}
    ],
    "board": [
      {"part": "Worst step, image in EEPROM", "takes": "[..]"},
      {"part": "Worst step, image in flash", "takes": "[..]"},
      {"part": "Stack below a step, the most that was seen", "takes": "[..]"}
    ],
    "bytes": [
      {"part": "Windows of rolling statistics", "bytes": 0},
      {"part": "Locals, and values on the way", "bytes": 0},
      {"part": "The VM's own", "bytes": 56},
      {"part": "RAM in all", "bytes": 56},
      {"part": "State vector", "bytes": 16},
      {"part": "Image, in flash or RAM", "bytes": 86},
      {"part": "of which code", "bytes": 16}
    ]}},
 "scripts": {"title": "Scripts",
   "text": [
    "No script was run. Name some behind the machine, as in `smc report tank.sm tank.ss`."]}
}
