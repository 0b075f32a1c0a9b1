# The table names the states of a requirement that no script came to, whether it was judged or not: R1 is met in Pad alone.
args test a.sm a.ss a.rq -w
args test a.sm a.ss b.ss a.rq -w | grep '^ '
args test a.sm a.ss a.rq --tap -w | grep 'no script'
args test a.sm a.ss a.rq --traceability=t.json -w >log; grep -o '"unvisited":"[^"]*"' t.json
args test --junit=j.xml a.sm a.ss a.rq -w >log; grep 'not visited' j.xml

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
bool go @read_only
bool stop @read_only
bool main
[Pad]
.step
    go: -> Burn
[Burn]
.entry
    main = true
.step
    stop: -> Hold
    T > 50: -> Off
[Hold]
.entry
    main = false
[Off] @safe
-- a.ss --
[all_states]
G == 50: go = true
G == 90: @assert S == Burn
G == 90: @stop
-- b.ss --
[all_states]
G == 50: go = true
G == 90: stop = true
G == 110: @assert S == Hold
G == 110: @stop
-- a.rq --
R1 "main stays off"   always (S == Pad or S == Hold or Off == S) implies not main
R2 "off after a hold" never Off after Hold without Pad
R3 "burns"            always S != Pad implies go
-- stdout --
state script ran for 10 steps
1 assert passed
final state vector:
  G = 90
  S = 2
  T = 30
  go = true
  main = true
  stop = false
requirements:
  R1  met           main stays off
      judged in a.ss: 6
      no script came to Hold, Off
  R2  never judged  off after a hold
      no script came to Hold, Off
  R3  met           burns
      judged in a.ss: 4
  R1  met           main stays off
      judged in a.ss: 6, b.ss: 8
      no script came to Off
  R2  never judged  off after a hold
      no script came to Off
  R3  met           burns
      judged in a.ss: 4, b.ss: 6
# no script came to Hold, Off
# no script came to Hold, Off
"unvisited":"Hold, Off"
"unvisited":"Hold, Off"
"unvisited":""
        <property name="not visited" value="Hold, Off"/>
        <property name="not visited" value="Hold, Off"/>
