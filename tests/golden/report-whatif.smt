# With --faults a report has the matrix of smc faults, and each cell the number of its line and of the script that reproduces it.  With --sweep it has
# the margins of each parameter.  The table of requirements joins tests, proofs and faults.  The overview names what was not examined.
args report a.sm a.ss a.rq --faults --sweep --format=text | sed -n '/Section  /,/^The machine/p; /^What breaks it/,/What it costs/p'
args report a.sm a.ss a.rq --scripts=made --format=text | grep -A 7 'With one fault, a requirement'; "$SMC" test a.sm a.rq made/001-*.ss >/dev/null; ls made
args report a.sm a.ss a.rq --prove --faults --format=text | grep -A 4 'Requirement  Text'
args report a.sm a.ss --all --format=json | grep -o '"verdict": "[a-z]*"' | sort | uniq -c | tr -d ' '
args report a.sm bad.ss --faults --sweep --format=text | grep -A 11 '^What breaks it'
args report a.sm --faults --sweep --format=text | grep -A 11 '^What breaks it'

-- a.sm --
[state_vector]
U64  time      @alias G
U32  state     @alias S
F32  altitude  @read_only @range -50 1000
bool drogue
[local]
F64 limit = 300 @parameter @range 100 500
bool unused = false @parameter

[Ascent]
.step
    altitude < limit and T > 100: -> Drogue
    T > 600: -> Drogue

[Drogue] @safe
.entry
    drogue = not unused
-- a.ss --
[options]
delta_t 10

[all_states]
true:   altitude = 400 + G
at 500: @assert not drogue "no charge in the ascent"
at 690: @assert altitude > 1000
at 700: @assert drogue
at 700: @stop
-- bad.ss --
[options]
delta_t 10
[all_states]
at 50: @assert drogue
at 50: @stop
-- a.rq --
R1 "no charge in the ascent"   # the pyro channel
    never  drogue and altitude > 300 and   G < 600   # in ms
R2 "it ends" always G > 10 implies S <= 2
-- stdout --
  Section            Verdict  Details
  Requirements       passed   2 met in all scripts
  Findings           open     2 open
  Scripts            passed   1 of 1 passed
  Coverage           open     18 of 29 places (62 %)
  Faults of sensors  failed   of input and kind: 3 violated, 2 failed, 5 without effect
  Parameters         open     1 with a known margin, 1 whose value nothing notices
  Longest step                8 instructions, in Ascent

Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided.
Failed: something is shown to be wrong.

Not examined: proofs of the requirements (`--prove`), changes that no script notices (`--mutate`).
`smc report --all` adds them.

  What speaks against it       How it is known
  R1: no charge in the ascent  6 faults of sensors violate it (What breaks it)
  2 open findings              W0903, W1304 (Findings)
  parameter limit              no script notices its value (Parameters at other values)

The machine has 2 states and starts in `Ascent`. It reads `altitude`. It writes `drogue`. It never
What breaks it
==============

Faults of sensors
-----------------

Each input is made faulty in each way, beginning in each state and at each transition that the
scripts take, and the scripts run again. The table has the most dangerous outcome of each input and
fault, with its number in the lists below. The name of a requirement: it is violated. `-> Abort`:
the script ends in this state, and not where it does without the fault. The name of an output: it
differs on the way, or an assert fails. `no @stop`: the script does not stop. `assert`: only an
assert fails. `+2`: two other effects as dangerous, with another beginning of the fault. `-`: no
effect. An empty cell: the input cannot have this fault. Requirements are judged for what the
machine reads and for the true values.

18 of 40 faults have an effect: 1 input, 4 triggers in 1 script.

  Input     stuck       dead    nan     low     high        below  above  noisy  late  dropped
  altitude  assert (4)  R1 (1)  R1 (2)  R1 (3)  assert (5)  -      -      -      -     -

With `--scripts=DIR`, `smc report` writes a script for each line, which reproduces it.

With one fault, a requirement is violated [violated]
  No.  Fault          Begins                                   What happens                                                                                                Other triggers
    1  altitude dead  from the start, in Ascent (G = 0, a.ss)  R1, by the true values, at G = 120; assert at a.ss:6 at G = 500; drogue = true instead of false at G = 120  1
    2  altitude nan   from the start, in Ascent (G = 0, a.ss)  R1, by the true values, at G = 120; assert at a.ss:6 at G = 500; drogue = true instead of false at G = 120  1
    3  altitude low   from the start, in Ascent (G = 0, a.ss)  R1, by the true values, at G = 120; assert at a.ss:6 at G = 500; drogue = true instead of false at G = 120  1

With one fault, an assert of a healthy flight fails [failed]
  No.  Fault           Begins                                    What happens                 Other triggers
    4  altitude stuck  from the start, in Ascent (G = 0, a.ss)   assert at a.ss:7 at G = 690  1
    5  altitude high   from the start, in Ascent (G = 0, a.ss)   assert at a.ss:7 at G = 690  3
    6  altitude dead   from Ascent -> Drogue on (G = 620, a.ss)  assert at a.ss:7 at G = 690  1
    7  altitude nan    from Ascent -> Drogue on (G = 620, a.ss)  assert at a.ss:7 at G = 690  1
    8  altitude low    from Ascent -> Drogue on (G = 620, a.ss)  assert at a.ss:7 at G = 690  1

Kinds of faults
  Fault    What the machine reads
  stuck    the last reading before the fault
  dead     0 or false
  nan      NaN, which a machine sees as 0; only floats
  low      the lowest value of the range
  high     the highest value of the range; true
  below    the true value less 5 % of the range
  above    the true value and 5 % of the range
  noisy    the true value and a random number with a standard deviation of 2 % of the range
  late     the true value of 5 steps before
  dropped  the last reading before the fault, for 10 steps

Parameters at other values
--------------------------

Each parameter is set to values over its whole range, the others stay as they are, and all scripts
run again that do not set it themselves. A margin is the distance from the current value of the
machine to the nearest value at which something fails. Between neighbouring values with different
results, the boundary was searched by bisection. Not noticed: nothing fails at any value, so these
scripts and requirements do not test the parameter. Only an assert: no requirement is violated at
the limit, and the assert may be the time line of one script.

  Parameter  Verdict         Now    Below                           Above
  limit      not noticed     300    nothing notices it down to 100  nothing notices it up to 500
  unused     only an assert  false                                  fails at true (only the assert a.ss:8)

`limit` from 100 to 500
  From  To   What fails
  100   500  nothing

`unused` from false to true
  From   To     What fails
  false  false  nothing
  true   true   a.ss:8

  Check   Passes at  Fails at
  a.ss:8  false      true

What it costs
With one fault, a requirement is violated [violated]
  No.  Fault          Begins                                   What happens                                                                                                Other triggers  Script
    1  altitude dead  from the start, in Ascent (G = 0, a.ss)  R1, by the true values, at G = 120; assert at a.ss:6 at G = 500; drogue = true instead of false at G = 120  1               001-altitude-dead.ss
    2  altitude nan   from the start, in Ascent (G = 0, a.ss)  R1, by the true values, at G = 120; assert at a.ss:6 at G = 500; drogue = true instead of false at G = 120  1               002-altitude-nan.ss
    3  altitude low   from the start, in Ascent (G = 0, a.ss)  R1, by the true values, at G = 120; assert at a.ss:6 at G = 500; drogue = true instead of false at G = 120  1               003-altitude-low.ss

With one fault, an assert of a healthy flight fails [failed]
  No.  Fault           Begins                                    What happens                 Other triggers  Script
001-altitude-dead.ss
002-altitude-nan.ss
003-altitude-low.ss
004-altitude-stuck.ss
005-altitude-high.ss
006-altitude-dead.ss
007-altitude-nan.ss
008-altitude-low.ss
  Requirement  Text                     Rule                                         Verdict   Proof     Faults that violate it first
  R1           no charge in the ascent  never drogue and altitude > 300 and G < 600  violated  violated  6
  R2           it ends                  always G > 10 implies S <= 2                 met       proved    none

Where each requirement is implemented and judged
  Requirement  Text                     Place   Implemented in  Judged in  Times  Result
  R1           no charge in the ascent  a.rq:1  nowhere         a.ss          71  met
  R2           it ends                  a.rq:3  nowhere         a.ss          69  met

Proofs
1"verdict":""
5"verdict":"open"
1"verdict":"passed"
What breaks it
==============

Faults of sensors
-----------------

No fault was tried, because every script fails anyway: the first, bad.ss, fails at bad.ss:4.

Parameters at other values
--------------------------

No parameter was changed, because every script fails anyway: the first, bad.ss, fails at bad.ss:4.
What breaks it
==============

Faults of sensors
-----------------

No fault was tried, because there is no script.

Parameters at other values
--------------------------

No parameter was changed, because there is no script.
-- stderr --
a.rq:3:1: warning: requirement R2 is never violated, whatever the machine does [W1304 decided-requirement]
    3 | R2 "it ends" always G > 10 implies S <= 2
      | ^~
1 warning
made/001-altitude-dead.ss:23:22: error: assert failed after step 13 (G = 120, state Drogue): as without the fault [E0750]
   23 | time == 120: @assert not drogue "as without the fault"
      |                      ^~~~~~~~~~ drogue = true
note: the last steps, and the values after each:
      step    G  state   drogue
         9   80  Ascent   false
        10   90  Ascent   false
        11  100  Ascent   false
        12  110  Ascent   false
        13  120  Drogue    true
a.sm:12:35: note: transition in step 12 (G = 110): Ascent -> Drogue
a.sm:17:5: note: step 13 (G = 120): `drogue = not unused` stored true: unused = false
1 error
smc: bad.ss failed; the report shows why
smc: Left out: bad.ss, because it fails at bad.ss:4.
smc: --sweep: no parameter was changed, because every script fails anyway: the first, bad.ss, fails at bad.ss:4
smc: --faults: no fault was tried, because every script fails anyway: the first, bad.ss, fails at bad.ss:4
smc: --sweep: no parameter was changed, because there is no script
smc: --faults: no fault was tried, because there is no script
