# Comparisons in words become the sign that they name. Where the rest of the condition has several readings, the line stays as it is.
args fix app.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q @read_only
U8 mode @read_only
bool fault @read_only
bool valve
bool pump
[Run] @safe
.step
    mode is not 5: valve = true
    mode IS NOT -5: valve = true
    mode equals not 5: valve = true
    mode is not equal to 5 AND p Is  Greater Than q: valve = true
    if p is at least 5 then valve = true
    p > 3 then: valve = true
    fault is not pump: valve = true
    valve = NOT fault AND NOT (p is below 3)
    mode is 5 or 6: valve = false
    mode is 5 or fault: valve = false
    mode is not not 5: valve = false
    if mode = not 5: valve = false
    if mode = 5 or 6: valve = false
    p is between 3 and 5: valve = false
    p is not greater than 5: valve = false
    p is greater then 5: valve = false
    NOT p > 5: valve = false
    not p is 5: valve = false
    if not p = 5: valve = false
    mode = 5 || 6: valve = false
    ~p > 5: valve = false
    ¬p > 5: valve = false
    if valve := p > 5: pump = false
    valve = true: pump = false
    p => q
        valve = false
    p > 50 % of q: valve = false
    p > 5 -- too high: valve = false
-- stdout --
app.sm:12:
  -     mode is not 5: valve = true
  -     mode IS NOT -5: valve = true
  -     mode equals not 5: valve = true
  -     mode is not equal to 5 AND p Is  Greater Than q: valve = true
  -     if p is at least 5 then valve = true
  -     p > 3 then: valve = true
  -     fault is not pump: valve = true
  -     valve = NOT fault AND NOT (p is below 3)
  +     mode != 5: valve = true
  +     mode != -5: valve = true
  +     mode != 5: valve = true
  +     mode != 5 and p > q: valve = true
  +     if p >= 5: valve = true
  +     p > 3: valve = true
  +     fault != pump: valve = true
  +     valve = not fault and not (p < 3)
app.sm:31:
  -     mode = 5 || 6: valve = false
  +     mode = 5 or 6: valve = false
app.sm: 15 fixed
-- stderr --
app.sm:20:10: error: 'is' is not part of this language [E0329]
   20 |     mode is 5 or 6: valve = false
      |          ^~ compare with == != < <= > or >=, and join comparisons with and, or
app.sm:21:10: error: 'is' is not part of this language [E0329]
   21 |     mode is 5 or fault: valve = false
      |          ^~ compare with == != < <= > or >=, and join comparisons with and, or
app.sm:22:10: error: 'is not' is not part of this language [E0329]
   22 |     mode is not not 5: valve = false
      |          ^~~~~~ compare with == != < <= > or >=, and join comparisons with and, or
app.sm:23:13: error: '=' assigns a value; use '==' to compare [E0324]
   23 |     if mode = not 5: valve = false
      |             ^ write ==
app.sm:23:15: warning: not 5 is a separate condition here and is never true [W0419 number-as-condition]
   23 |     if mode = not 5: valve = false
      |               ^~~~~ did you mean 'mode != 5'?
app.sm:24:13: error: '=' assigns a value; use '==' to compare [E0324]
   24 |     if mode = 5 or 6: valve = false
      |             ^ write ==
app.sm:24:20: warning: 6 is a separate condition here and is always true [W0419 number-as-condition]
   24 |     if mode = 5 or 6: valve = false
      |                    ^ did you mean 'mode == 6'?
app.sm:25:7: error: 'is' is not part of this language [E0329]
   25 |     p is between 3 and 5: valve = false
      |       ^~ compare with == != < <= > or >=, and join comparisons with and, or
app.sm:26:7: error: 'is not' is not part of this language [E0329]
   26 |     p is not greater than 5: valve = false
      |       ^~~~~~ compare with == != < <= > or >=, and join comparisons with and, or
app.sm:27:7: error: 'is' is not part of this language [E0329]
   27 |     p is greater then 5: valve = false
      |       ^~ compare with == != < <= > or >=, and join comparisons with and, or
app.sm:28:5: error: 'NOT' is not part of this language [E0329]
   28 |     NOT p > 5: valve = false
      |     ^~~ write not (...)
app.sm:29:11: error: 'is' is not part of this language [E0329]
   29 |     not p is 5: valve = false
      |           ^~ compare with == != < <= > or >=, and join comparisons with and, or
app.sm:30:8: warning: 'not' applies only to the next value [W0401 not-precedence]
   30 |     if not p = 5: valve = false
      |        ^~~~~
note: as written: (not p) = 5
note: perhaps meant: not (p = 5)
app.sm:30:14: error: '=' assigns a value; use '==' to compare [E0324]
   30 |     if not p = 5: valve = false
      |              ^ write ==
app.sm:31:10: error: '=' assigns a value; use '==' to compare [E0324]
   31 |     mode = 5 or 6: valve = false
      |          ^ write ==
app.sm:31:12: warning: 5 is a separate condition here and is always true [W0419 number-as-condition]
   31 |     mode = 5 or 6: valve = false
      |            ^
app.sm:31:17: warning: 6 is a separate condition here and is always true [W0419 number-as-condition]
   31 |     mode = 5 or 6: valve = false
      |                 ^
app.sm:32:5: error: '~' is written 'not' here [E0107]
   32 |     ~p > 5: valve = false
      |     ^ write not
app.sm:32:5: warning: 'not' applies only to the next value [W0401 not-precedence]
   32 |     ~p > 5: valve = false
      |     ^~
note: as written: (not p) > 5
note: perhaps meant: not (p > 5)
app.sm:33:5: error: the character '¬' is allowed only in comments [E0102]
   33 |     ¬p > 5: valve = false
      |     ^ write not (...)
app.sm:33:5: warning: 'not' applies only to the next value [W0401 not-precedence]
   33 |     ¬p > 5: valve = false
      |     ^~
note: as written: (not p) > 5
note: perhaps meant: not (p > 5)
app.sm:34:14: error: ':=' is written '=' here [E0107]
   34 |     if valve := p > 5: pump = false
      |              ^~ write =
app.sm:35:11: error: '=' assigns a value; use '==' to compare [E0324]
   35 |     valve = true: pump = false
      |           ^ write ==
app.sm:36:7: error: '=>' is written '>=' here [E0107]
   36 |     p => q
      |       ^~ write >=
app.sm:38:12: error: a comment begins with '#', not with '%' [E0110]
   38 |     p > 50 % of q: valve = false
      |            ^ write a percentage as a factor, as in 0.5 * x; a comment begins with #
app.sm:39:11: error: a comment begins with '#', not with '--' [E0110]
   39 |     p > 5 -- too high: valve = false
      |           ^~ begin the comment with #
19 errors, 7 warnings
-- exit --
1
