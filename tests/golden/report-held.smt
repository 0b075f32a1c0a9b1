# A report describes `held` as the condition that it is, with its time or steps, and counts no samples of a time.  A condition that no script made true
# is code on the page, and a diagram explains its dotted lines itself.
args report a.sm a.ss --format=text | sed -n '/^Rolling/,/^$/p; /^  Call/,/^$/p'
args report a.sm a.ss -o a.html; grep -o '<code>bad</code> was never true' a.html; grep -c 'Dotted: ' a.html; grep -c 'states that no script has visited' a.html

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool bad @read_only
[define]
WAIT = 2 s
[Run]
.step
    held(p > 60, 30 ms): -> Stop
    held(p > 50, 4 steps): -> Stop
    held(p > 40, WAIT): -> Stop
    bad: -> Stop
[Stop] @safe
-- a.ss --
[all_states]
true: p = 1
at 50: @assert state Run
at 50: @stop
-- stdout --
Rolling statistics
Every window takes a sample at the start of every step, in every state. Until it is full, its
statistic covers the samples taken so far.

  Call                   Meaning                                                Steps  Line
  held(p > 60, 30 ms)    whether `p > 60` has been true for `30 ms`                      12
  held(p > 50, 4 steps)  whether `p > 50` was true in each of the last 4 steps      4    13
  held(p > 40, WAIT)     whether `p > 40` has been true for `WAIT`                       14

<code>bad</code> was never true
1
0
-- exit --
0 1
