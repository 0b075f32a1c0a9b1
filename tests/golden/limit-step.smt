# A step that can take more instructions than --max-step allows is an error with the state and its dearest lines; nothing is
# written. Limits that hold are not worth a word.
args build a.sm --max-step=6
args build a.sm --max-step=100 --max-ram=1000
args check a.sm --max-step=6
args check a.sm --max-step=100 --max-ram=1000

-- a.sm --
[state_vector]
U64 G
U32 S
F32 pressure @read_only
F32 limit
bool open
[Idle]
.step
    pressure > 5: -> Vent
[Vent]
.entry
    open = true
.step
    limit = pressure * pressure + 2 * pressure + roll_avg(pressure, 10)
    pressure < 2: -> Idle
.exit
    open = false
-- stderr --
a.sm:10:2: error: a step of machine 'a' in state 'Vent' can take 26 instructions, but --max-step allows 6 [E0861]
   10 | [Vent]
      |  ^~~~
a.sm:14:5: note: 14 of them are for this line
a.sm:14:5: note: 3 of them are for the samples of this line's windows, in every step
a.sm:12:5: note: 3 of them are for this line
1 error
a.sm:10:2: error: a step of machine 'a' in state 'Vent' can take 26 instructions, but --max-step allows 6 [E0861]
   10 | [Vent]
      |  ^~~~
a.sm:14:5: note: 14 of them are for this line
a.sm:14:5: note: 3 of them are for the samples of this line's windows, in every step
a.sm:12:5: note: 3 of them are for this line
1 error
-- exit --
1 0 1 0
