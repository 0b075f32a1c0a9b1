# smc fix -Wextra writes guards by time for comparisons with G that are a whole guard, with a unit of time. It leaves those that no step
# meets, those with other bounds, hexadecimal numbers, and machines, where G is compared as ever.
args check -Wextra app.sm app.ss
args fix -Wextra app.sm app.ss
args check -Wextra app.sm app.ss

-- app.sm --
[state_vector]
U64 time @alias G
U32 S
F64 x
[Hold]
.step
    time == 5000: x = 1
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: x = 1
5000 == time: x = 1
G == 1.5 s: x = 1
time >= 120 { x = 1 }
if G >= 120 and G < 2000 {
    G == 150: x = 7
    else if 160 == G: x = 8
    else: x = 2
}
120 <= G < 60000: x = 2
G == 0x1e: x = 3
G == 15: x = 3
G > 30: x = 3
(G == 30): x = 3
G == 30 and x > 3: x = 3
2000 <= G < 2005 and x > 3: x = 3
15 <= G < 18: x = 3
G != 40: x = 3
[Hold]
G == 100 {
    @assert x == 3
    @stop
}
-- stdout --
app.ss:4:
  - G == 0: x = 1
  - 5000 == time: x = 1
  - G == 1.5 s: x = 1
  - time >= 120 { x = 1 }
  - if G >= 120 and G < 2000 {
  -     G == 150: x = 7
  -     else if 160 == G: x = 8
  + at 0: x = 1
  + at 5 s: x = 1
  + at 1.5 s: x = 1
  + after 120 ms { x = 1 }
  + if from 120 ms to 2 s {
  +     at 150 ms: x = 7
  +     else if at 160 ms: x = 8
app.ss:13:
  - 120 <= G < 60000: x = 2
  + from 120 ms to 60 s: x = 2
app.ss:23:
  - G == 100 {
  + at 100 ms {
app.ss: 9 fixed
-- stderr --
app.sm:7:5: warning: 'time' is possibly never exactly 5000 [W0408 exact-moment]
    7 |     time == 5000: x = 1
      |     ^~~~~~~~~~~~
app.ss:4:1: warning: 'G == 0' can be a guard by time [W0758 guard-by-time]
    4 | G == 0: x = 1
      | ^~~~~~ write at 0
app.ss:5:1: warning: '5000 == time' can be a guard by time [W0758 guard-by-time]
    5 | 5000 == time: x = 1
      | ^~~~~~~~~~~~ write at 5 s
app.ss:6:1: warning: 'G == 1.5 s' can be a guard by time [W0758 guard-by-time]
    6 | G == 1.5 s: x = 1
      | ^~~~~~~~~~ write at 1.5 s
app.ss:7:1: warning: 'time >= 120' can be a guard by time [W0758 guard-by-time]
    7 | time >= 120 { x = 1 }
      | ^~~~~~~~~~~ write after 120 ms
app.ss:8:4: warning: 'G >= 120 and G < 2000' can be a guard by time [W0758 guard-by-time]
    8 | if G >= 120 and G < 2000 {
      |    ^~~~~~~~~~~~~~~~~~~~~ write from 120 ms to 2 s
app.ss:9:5: warning: 'G == 150' can be a guard by time [W0758 guard-by-time]
    9 |     G == 150: x = 7
      |     ^~~~~~~~ write at 150 ms
app.ss:10:13: warning: '160 == G' can be a guard by time [W0758 guard-by-time]
   10 |     else if 160 == G: x = 8
      |             ^~~~~~~~ write at 160 ms
app.ss:13:1: warning: '120 <= G < 60000' can be a guard by time [W0758 guard-by-time]
   13 | 120 <= G < 60000: x = 2
      | ^~~~~~~~~~~~~~~~ write from 120 ms to 60 s
app.ss:15:1: warning: 'G' is never exactly 15: it advances by 10 [W0702 exact-moment]
   15 | G == 15: x = 3
      | ^~~~~~~
app.ss:23:1: warning: 'G == 100' can be a guard by time [W0758 guard-by-time]
   23 | G == 100 {
      | ^~~~~~~~ write at 100 ms
11 warnings
app.sm:7:5: warning: 'time' is possibly never exactly 5000 [W0408 exact-moment]
    7 |     time == 5000: x = 1
      |     ^~~~~~~~~~~~
app.ss:15:1: warning: 'G' is never exactly 15: it advances by 10 [W0702 exact-moment]
   15 | G == 15: x = 3
      | ^~~~~~~
2 warnings
app.sm:7:5: warning: 'time' is possibly never exactly 5000 [W0408 exact-moment]
    7 |     time == 5000: x = 1
      |     ^~~~~~~~~~~~
app.ss:15:1: warning: 'G' is never exactly 15: it advances by 10 [W0702 exact-moment]
   15 | G == 15: x = 3
      | ^~~~~~~
2 warnings
