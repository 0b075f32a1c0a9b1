# Every report of a script with random numbers has the seed: of the script, or of --seed. Others have none.
args test app.sm a.ss
args test --seed=5 app.sm a.ss
args test --seed 7 --tap app.sm a.ss plain.ss
args test --seed=5 app.sm wrong.ss
args report app.sm a.ss --format=text -o - | grep seed
args test --junit=r.xml app.sm a.ss >r.txt; grep seed r.xml
args test --junit=r.xml app.sm a.ss >r.txt && echo again
args test --seed=1.5 app.sm a.ss
args test --seed=9007199254740993 app.sm a.ss
args test --seed= app.sm a.ss

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold] @safe
.step
    x = p
-- a.ss --
[options]
delta_t 10
seed 42
[all_states]
true: p = random(0, 1)
at 20 ms {
    @assert 0 <= x < 1
    @stop
}
-- plain.ss --
[options]
delta_t 10
[all_states]
at 20 ms: @assert x == 0
at 20 ms: @stop
-- wrong.ss --
[options]
delta_t 10
[all_states]
true: p = noise(2)
at 30 ms: @assert noise(1) > 100 and x == p
at 40 ms: @stop
-- stdout --
state script ran for 3 steps
1 assert passed
seed 42
final state vector:
  G = 20
  S = 1
  T = 20
  p = 0.244358
  x = 0.244358
state script ran for 3 steps
1 assert passed
seed 5
final state vector:
  G = 20
  S = 1
  T = 20
  p = 0.415098
  x = 0.415098
TAP version 13
1..2
ok 1 - a.ss
# seed: 7
ok 2 - plain.ss
The random numbers have the seed 42.
        <property name="seed" value="42"/>
again
-- stderr --
wrong.ss:5:19: error: assert failed after step 4 (G = 30, state Hold) [E0750]
    5 | at 30 ms: @assert noise(1) > 100 and x == p
      |                   ^~~~~~~~~~~~~~~~~~~~~~~~~ noise(1) = 0.026378226466476917, x = -3.0858222930692136, p = -3.0858222930692136
note: the last steps, and the values after each:
      step   G  state                    x                    p
         1   0  Hold    2.6550142196938396   2.6550142196938396
         2  10  Hold   -3.4044971386902034  -3.4044971386902034
         3  20  Hold    1.6539578600786626   1.6539578600786626
         4  30  Hold   -3.0858222930692136  -3.0858222930692136
note: the machine has been in state 'Hold' from the start
app.sm:8:5: note: step 4 (G = 30): `x = p` stored -3.0858222930692136
note: the random numbers have seed 5
1 error
smc: --seed requires a whole number from 0 to 9007199254740992, not '1.5'
Try 'smc test --help'.
smc: --seed requires a whole number from 0 to 9007199254740992, not '9007199254740993'
Try 'smc test --help'.
smc: option '--seed' has an empty N
Try 'smc test --help'.
-- exit --
0 0 0 1 0 0 0 2 2 2
