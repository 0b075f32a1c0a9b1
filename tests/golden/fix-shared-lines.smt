# Statements that share a line after a condition go into braces together; indented lines after a colon do, too.
args fix app.sm
args check app.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool hot @read_only
U8 code
bool valve
[Burn]
.entry
    valve = true; code = 0   # both
.step
    p > 50: code = 1; -> Abort   # too high
    if hot: code = 2, -> Abort
    else if p > 40: code = 3 and then -> Abort
    else: code = 4; valve = p > 10;
    hot { p > 30: code = 5; -> Abort }
    p > 20 then code = 6, -> Abort
    if p < 1:
        # burst
        code = 7; valve = false

        -> Abort   # at once
    T > 100:
        hot:
            -> Abort
.exit
    valve = false
[Abort] @abort @safe
-- file app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool hot @read_only
U8 code
bool valve
[Burn]
.entry
    valve = true
    code = 0   # both
.step
    p > 50 {
        code = 1
        -> Abort   # too high
    }
    if hot {
        code = 2
        -> Abort
    }
    else if p > 40 {
        code = 3
        -> Abort
    }
    else {
        code = 4
        valve = p > 10
    }
    hot { p > 30 {
            code = 5
            -> Abort
        } }
    p > 20 {
        code = 6
        -> Abort
    }
    if p < 1 {
        # burst
        code = 7
        valve = false

        -> Abort   # at once
    }
    T > 100 {
        hot {
            -> Abort
        }
    }
.exit
    valve = false
[Abort] @abort @safe
-- stdout --
app.sm:10:
  -     valve = true; code = 0   # both
  +     valve = true
  +     code = 0   # both
app.sm:12:
  -     p > 50: code = 1; -> Abort   # too high
  -     if hot: code = 2, -> Abort
  -     else if p > 40: code = 3 and then -> Abort
  -     else: code = 4; valve = p > 10;
  -     hot { p > 30: code = 5; -> Abort }
  -     p > 20 then code = 6, -> Abort
  -     if p < 1:
  -         # burst
  -         code = 7; valve = false
  - 
  -         -> Abort   # at once
  -     T > 100:
  -         hot:
  +     p > 50 {
  +         code = 1
  +         -> Abort   # too high
  +     }
  +     if hot {
  +         code = 2
  +         -> Abort
  +     }
  +     else if p > 40 {
  +         code = 3
  +         -> Abort
  +     }
  +     else {
  +         code = 4
  +         valve = p > 10
  +     }
  +     hot { p > 30 {
  +             code = 5
app.sm:26:
  - .exit
  -     valve = false
  - [Abort] @abort @safe
  +         } }
  +     p > 20 {
  +         code = 6
  +         -> Abort
  +     }
  +     if p < 1 {
  +         # burst
  +         code = 7
  +         valve = false
app.sm:30:
  +         -> Abort   # at once
  +     }
  +     T > 100 {
  +         hot {
  +             -> Abort
  +         }
  +     }
  + .exit
  +     valve = false
  + [Abort] @abort @safe
  + 
app.sm: 12 fixed
-- stderr --
app.sm:11:5: warning: the value assigned to 'code' is overwritten before it is read [W0410 dead-store]
   11 |     code = 0   # both
      |     ^~~~~~~~
app.sm:14:9: note: it is overwritten here
app.sm:29:5: warning: this condition repeats an earlier one and is never true here [W0507 duplicate-guard]
   29 |     hot { p > 30 {
      |     ^~~
app.sm:17:5: note: the earlier condition is here
app.sm:40:9: warning: the value assigned to 'valve' is overwritten before it is read [W0410 dead-store]
   40 |         valve = false
      |         ^~~~~~~~~~~~~
app.sm:50:5: note: it is overwritten here
app.sm:45:9: warning: this condition repeats an earlier one and is never true here [W0507 duplicate-guard]
   45 |         hot {
      |         ^~~
app.sm:17:5: note: the earlier condition is here
4 warnings
app.sm:11:5: warning: the value assigned to 'code' is overwritten before it is read [W0410 dead-store]
   11 |     code = 0   # both
      |     ^~~~~~~~
app.sm:14:9: note: it is overwritten here
app.sm:29:5: warning: this condition repeats an earlier one and is never true here [W0507 duplicate-guard]
   29 |     hot { p > 30 {
      |     ^~~
app.sm:17:5: note: the earlier condition is here
app.sm:40:9: warning: the value assigned to 'valve' is overwritten before it is read [W0410 dead-store]
   40 |         valve = false
      |         ^~~~~~~~~~~~~
app.sm:50:5: note: it is overwritten here
app.sm:45:9: warning: this condition repeats an earlier one and is never true here [W0507 duplicate-guard]
   45 |         hot {
      |         ^~~
app.sm:17:5: note: the earlier condition is here
4 warnings
