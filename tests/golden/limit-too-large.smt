# A number that is too large for its option: the message names the largest value.
args test a.sm a.ss --max-steps=18446744073709551616
args test a.sm a.ss --max-steps=18446744073709551615
args why a.sm a.ss --max-steps=18446744073709551616
args why a.sm a.ss --at-step=99999999999999999999
args mutate a.sm a.ss --max-steps=99999999999999999999
args diff a.sm a.sm a.ss --max-steps=99999999999999999999
args sweep a.sm a.ss --max-steps=99999999999999999999
args faults a.sm a.ss --max-steps=99999999999999999999
args faults a.sm a.ss --max-runs=99999999999999999999
args test a.sm a.ss --step=4294967296
args check a.sm --step=99999999999999999999
args check a.sm --max-ram=4294967296
args report a.sm --time=10000001

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 20: @stop
-- stdout --
state script ran for 3 steps
0 asserts passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
-- stderr --
smc: --max-steps can be at most 18446744073709551615, not '18446744073709551616'
Try 'smc test --help'.
a.ss:4:10: warning: the script has no @assert, @expect or @fail: it tests only that @stop is reached [W0751 script-without-assert]
    4 | G == 20: @stop
      |          ^~~~~
1 warning
smc: --max-steps can be at most 18446744073709551615, not '18446744073709551616'
Try 'smc why --help'.
smc: --at-step can be at most 18446744073709551615, not '99999999999999999999'
Try 'smc why --help'.
smc: --max-steps can be at most 18446744073709551615, not '99999999999999999999'
Try 'smc mutate --help'.
smc: --max-steps can be at most 18446744073709551615, not '99999999999999999999'
Try 'smc diff --help'.
smc: --max-steps can be at most 18446744073709551615, not '99999999999999999999'
Try 'smc sweep --help'.
smc: --max-steps can be at most 18446744073709551615, not '99999999999999999999'
Try 'smc faults --help'.
smc: --max-runs can be at most 18446744073709551615, not '99999999999999999999'
Try 'smc faults --help'.
smc: --step can be at most 4294967295, not '4294967296'
Try 'smc test --help'.
smc: --step can be at most 4294967295, not '99999999999999999999'
Try 'smc check --help'.
smc: --max-ram can be at most 4294967295, not '4294967296'
Try 'smc check --help'.
smc: --time can be at most 10000000, not '10000001'
Try 'smc report --help'.
-- exit --
2 0 2 2 2 2 2 2 2 2 2 2 2
