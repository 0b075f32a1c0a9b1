# The example of the README: its report is the one of the thesis, Figure 3.4, to the letter, on every engine.
args test --engine=all "$ROOT/examples/tank/tank.sm" "$ROOT/examples/tank/tank.ss"

-- stdout --
state script ran for 101 steps
100 asserts passed
final state vector:
  G = 1000
  P_AbortThreshold = 825
  P_WarnThreshold = 800
  S = 1
  T = 1000
  counter = 0
  tankPressure = 701.000000
  valveOpen = false
