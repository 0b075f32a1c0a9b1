# smc fix -Wextra writes guards by time for comparisons with G that are a whole guard, with a unit of time. It leaves those that no step
# meets, those with other bounds, hexadecimal numbers, and machines, where G is compared as ever.
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
