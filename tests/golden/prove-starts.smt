# smc prove on first steps: samples before the first one, runs, edges, locals and T begin as the language says.  What the first steps can do is not
# called impossible.
args prove a.sm a.rq --effort=1 | grep '^  S'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only
bool a      @read_only
bool b      @read_only
bool early
bool late

[local]
U8   count = 3

[One]
.step
    early = roll_min(a, 3) == 1 or roll_max(b, 3) == 0
    late = roll_min(a, 3) == 1 and roll_max(b, 3) == 0
    count = count + 1
    prev(p) > 5 and count < 5: -> Two
    held(a, 30 ms): -> Three

[Two]
.step
    late = T == 0
    a: -> One

[Three]
-- a.rq --
S1 "the minimum of one sample"      never early and G == 0 and a
S2 "the maximum of one sample"      never early and G == 0 and not b
S3 "both, of two samples"           never late and G == 10 and S == One
S4 "the same in the requirement"    always G == 0 and a implies roll_min(a, 3) == 0
S5 "the same of the maximum"        always G == 0 and not b implies roll_max(b, 3) == 1
S6 "the sample before the first"    never S == Two and G == 10
S7 "the same in the requirement"    never G == 0 and prev(p) > 5
S8 "a run begins with no sample"    always a implies held(a, 20 ms)
S9 "two samples are one step"       always held(a, 10 ms) implies G > 10
S10 "not in the first step"         always held(a, 10 ms) implies G >= 10
S11 "a local has its value"         never S == Two and count != 4
S12 "T begins again"                always S == Two and T == 0 implies not late
S13 "nothing is seen at first"      never One before Two
S14 "no rise in the first step"     never rising(a) and G == 0
S15 "nor a fall"                    never G == 0 and falling(a)
S16 "a rise in the second"          never rising(a) and G == 10
S17 "no run of Three before 40 ms"  never S == Three and G < 40
S18 "but then"                      never S == Three and G <= 40
S19 "any first time"                always S == One and T == 0 implies G == 0
-- stdout --
  S1   violated            the minimum of one sample
  S2   violated            the maximum of one sample
  S3   violated            both, of two samples
  S4   violated            the same in the requirement
  S5   violated            the same of the maximum
  S6   violated            the sample before the first
  S7   violated            the same in the requirement
  S8   violated            a run begins with no sample
  S9   violated            two samples are one step
  S10  proved              not in the first step
  S11  proved              a local has its value
  S12  violated            T begins again
  S13  violated            nothing is seen at first
  S14  proved              no rise in the first step
  S15  proved              nor a fall
  S16  violated            a rise in the second
  S17  proved              no run of Three before 40 ms
  S18  violated            but then
  S19  violated            any first time
