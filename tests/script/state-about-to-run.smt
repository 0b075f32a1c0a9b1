# Guards see T and S as the step about to run has them: at a first step, of a self transition too, T is 0.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 n
[First]
.step
    n = n + 1
    n == 3: -> First
    n == 5: -> Second
[Second]
.step
    T == 20: -> First
-- app.ss --
[options]
delta_t 10
[First]
G == 0 and T == 0 and S == 1:    @assert n == 1
G == 20 and T == 20 and S == 1:  @assert n == 3 and T == 20 and S == 1   #! W0752
G == 30 and T == 0 and S == 1:   @assert n == 4
G == 40 and T == 10:             @assert n == 5
G == 80 and T == 0 and S == 1:   @assert n == 6
G == 90: @stop
[Second]
G == 50 and T == 0 and S == 2:   @assert n == 5 and S == 2 and T == 0   #! W0752
G == 60 and T == 10:             @assert T == 10
G == 70 and T == 20:             @assert T == 20
-- report --
state script ran for 10 steps
8 asserts passed
final state vector:
  G = 90
  S = 1
  T = 10
  n = 7
