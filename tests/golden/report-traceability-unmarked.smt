# A machine without a mark @req has no table of its parts, and asserts without @req have none.
args report a.sm a.ss a.rq --format=text | sed -n '/^Traceability$/,/^Findings$/p'

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open
[Fill]
.step
    open = p > 700
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 800
G == 20: @assert open
G == 30: @stop
-- a.rq --
R1 "opens"     always p > 750 implies open
-- stdout --
Traceability
------------

From requirements to the machine: each mark `@req`. From the machine to requirements: a part has
those of its own marks, of the conditionals around it, and of its state; a state without a mark has
those of the marks inside it. A part without any is code that no requirement asks for, or a mark is
missing.

1 requirement: 1 tested; 1 output, 1 state without a requirement


No state, transition or statement has a mark `@req`, so this page cannot say which requirement a
part of the machine is for. `@req R1` after a statement or the header of a state says it.

No assert names a requirement.

Findings
