# The mistake of the thesis, Figure 3.3: a zero for the letter O, in the state of Figure 2.7.
args check tank.sm

-- tank.sm --
[state_vector]
U64  time           @alias G
U32  state          @alias S
F64  tankPressure  @read_only
bool  valveOpen

[local]
F64  pi              = 3.14159 @read_only
U16  P_WarnThreshold = 800
U16  P_AbortThreshold = P_WarnThreshold + 25
U64  counter         = 0
[TankVentControl]
.entry
  counter = 0
.step
  if tankPressure > 775 {
    valve0pe = true
    counter = counter + 1
  }
  else: valveOpen = false
  not (500 < tankPressure < P_AbortThreshold): -> Abort
  counter > 1000 and T > 4000: -> Idle
.exit
  valveOpen = true
[Idle]
[Abort]
-- stderr --
tank.sm:17:5: error: unknown element 'valve0pe' [E0204]
   17 |     valve0pe = true
      |     ^~~~~~~~ did you mean 'valveOpen'?
tank.sm:5:7: note: 'valveOpen' is declared here
1 error
-- exit --
1
