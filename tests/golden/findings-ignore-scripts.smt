# What is found in a machine, and which @allow is needed, does not depend on the locals that its scripts write.
args check -Wflight -Werror=unused-allow a.sm
args check -Wflight -Werror=unused-allow a.sm a.ss
args test -Wflight -Werror=unused-allow a.sm a.ss
args build -Wflight -Werror=unused-allow a.sm
args report a.sm a.ss --format=text | grep -E '^ +[0-9]+  [a-z-]+  ' | grep W0
args graph -Wflight a.sm a.ss -o a.dot
args fix -Wflight a.sm a.ss

-- a.sm --
[state_vector]
U64   time        @alias G
U32   state       @alias S
F64   altitude    @read_only
F64   ratio
bool  mainPyro

[local]
F64  pad = 0
F64  unit = 0
F64  scale = 0   @allow(never-written, "set on the bench")

[Pad]
.entry
    pad = altitude
.step
    ratio = altitude / unit
    scale > 1: -> Fall
    T > 1000: -> Fall

[Fall] @safe
.step
    altitude < pad + 300: mainPyro = true
-- a.ss --
[options]
delta_t 10
init_state Fall
[all_states]
G == 0 {
    pad = 100
    unit = 2
    scale = 2
}
G == 50: @assert mainPyro
G == 100: @stop
-- stdout --
state script ran for 11 steps
1 assert passed
final state vector:
  G = 100
  S = 2
  T = 100
  altitude = 0.000000
  mainPyro = true
  pad = 100.000000
  ratio = 0.000000
  scale = 2.000000
  unit = 2.000000
    1  never-written     on by default  a.sm:10:6   local 'unit' is never assigned, so it is a constant: mark it @read_only          W0207
    2  division-by-zero  on by default  a.sm:17:24  this divides by zero                                                             W0407
    3  output-on-zero    -Wflight       a.sm:23:27  'altitude' alone switches on 'mainPyro' when it reads 0, as a broken sensor can  W0903
-- stderr --
a.sm:10:6: warning: local 'unit' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
   10 | F64  unit = 0
      |      ^~~~
a.sm:17:24: warning: this divides by zero [W0407 division-by-zero]
   17 |     ratio = altitude / unit
      |                        ^~~~
a.sm:23:27: warning: 'altitude' alone switches on 'mainPyro' when it reads 0, as a broken sensor can [W0903 output-on-zero]
   23 |     altitude < pad + 300: mainPyro = true
      |                           ^~~~~~~~~~~~~~~
note: for example in 'Fall': 'altitude' reads 1.894e+06, then 0; this happens in step 1 after that
note: require that 'altitude' is plausible, or that a second sensor agrees
3 warnings
a.sm:10:6: warning: local 'unit' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
   10 | F64  unit = 0
      |      ^~~~
a.sm:17:24: warning: this divides by zero [W0407 division-by-zero]
   17 |     ratio = altitude / unit
      |                        ^~~~
a.sm:23:27: warning: 'altitude' alone switches on 'mainPyro' when it reads 0, as a broken sensor can [W0903 output-on-zero]
   23 |     altitude < pad + 300: mainPyro = true
      |                           ^~~~~~~~~~~~~~~
note: for example in 'Fall': 'altitude' reads 1.894e+06, then 0; this happens in step 1 after that
note: require that 'altitude' is plausible, or that a second sensor agrees
3 warnings
a.sm:10:6: warning: local 'unit' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
   10 | F64  unit = 0
      |      ^~~~
a.sm:17:24: warning: this divides by zero [W0407 division-by-zero]
   17 |     ratio = altitude / unit
      |                        ^~~~
a.sm:23:27: warning: 'altitude' alone switches on 'mainPyro' when it reads 0, as a broken sensor can [W0903 output-on-zero]
   23 |     altitude < pad + 300: mainPyro = true
      |                           ^~~~~~~~~~~~~~~
note: for example in 'Fall': 'altitude' reads 1.894e+06, then 0; this happens in step 1 after that
note: require that 'altitude' is plausible, or that a second sensor agrees
3 warnings
a.sm:10:6: warning: local 'unit' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
   10 | F64  unit = 0
      |      ^~~~
a.sm:17:24: warning: this divides by zero [W0407 division-by-zero]
   17 |     ratio = altitude / unit
      |                        ^~~~
a.sm:23:27: warning: 'altitude' alone switches on 'mainPyro' when it reads 0, as a broken sensor can [W0903 output-on-zero]
   23 |     altitude < pad + 300: mainPyro = true
      |                           ^~~~~~~~~~~~~~~
note: for example in 'Fall': 'altitude' reads 1.894e+06, then 0; this happens in step 1 after that
note: require that 'altitude' is plausible, or that a second sensor agrees
3 warnings
a.sm:10:6: warning: local 'unit' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
   10 | F64  unit = 0
      |      ^~~~
a.sm:17:24: warning: this divides by zero [W0407 division-by-zero]
   17 |     ratio = altitude / unit
      |                        ^~~~
a.sm:23:27: warning: 'altitude' alone switches on 'mainPyro' when it reads 0, as a broken sensor can [W0903 output-on-zero]
   23 |     altitude < pad + 300: mainPyro = true
      |                           ^~~~~~~~~~~~~~~
note: for example in 'Fall': 'altitude' reads 1.894e+06, then 0; this happens in step 1 after that
note: require that 'altitude' is plausible, or that a second sensor agrees
3 warnings
a.sm:10:6: warning: local 'unit' is never assigned, so it is a constant: mark it @read_only [W0207 never-written]
   10 | F64  unit = 0
      |      ^~~~
a.sm:17:24: warning: this divides by zero [W0407 division-by-zero]
   17 |     ratio = altitude / unit
      |                        ^~~~
a.sm:23:27: warning: 'altitude' alone switches on 'mainPyro' when it reads 0, as a broken sensor can [W0903 output-on-zero]
   23 |     altitude < pad + 300: mainPyro = true
      |                           ^~~~~~~~~~~~~~~
note: for example in 'Fall': 'altitude' reads 1.894e+06, then 0; this happens in step 1 after that
note: require that 'altitude' is plausible, or that a second sensor agrees
3 warnings
