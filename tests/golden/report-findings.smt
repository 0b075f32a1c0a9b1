# The findings of the analyses, and those that are allowed with a reason. A local that a script writes is not a constant. Findings of the run are listed too.
args report a.sm a.ss --format=text

-- a.sm --
[state_vector]
U64 G
U32 S
F32 spare @read_only @allow(unused-element, "wired, for the next flight")
F32 unused @read_only
bool valve
[local]
F64 wait = 100
[Idle]
.step
    valve = not valve
    T > wait: -> Idle
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: wait = 50
G == 5: @assert valve
G == 500: @stop
-- stdout --
...
Findings
--------

Findings of all groups of warnings. `smc explain` with a name or code prints what a finding means
and what to do. Time advances by 10 per step, the `delta_t` of the scripts.

  No.  Name            Group          Position  Finding                                                                  Code
    1  unused-element  on by default  a.sm:5:5  element 'unused' is never used                                           W0203
    2  never-written   on by default  a.sm:8:5  local 'wait' is never assigned, so it is a constant: mark it @read_only  W0207

Allowed findings
  No.  Name            Position  Finding                        Reason
    3  unused-element  a.sm:4:5  element 'spare' is never used  wired, for the next flight

element 'unused' is never used [W0203 unused-element]
      5 | F32 unused @read_only

local 'wait' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
      8 | F64 wait = 100

element 'spare' is never used [allowed]
Allowed: wired, for the next flight

      4 | F32 spare @read_only @allow(unused-element, "wired, for the next flight")

Abort matrix
...
a.ss [passed]
this assert was never evaluated [W0750 unjudged-assert]
...
