# The example of the README: its report is the one of the thesis, Figure 3.4, to the letter, on every engine.
args test --engine=all "$ROOT/examples/tank/tank.sm" "$ROOT/examples/tank/tank.ss"

-- stdout --
state script ran for 111 steps
110 asserts passed
final state vector:
  G = 1100
  P_AbortThreshold = 825
  P_WarnThreshold = 800
  S = 3
  T = 110
  counter = 72
  tankPressure = 837.000000
  valveOpen = true
