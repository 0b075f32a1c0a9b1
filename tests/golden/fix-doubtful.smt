# What has several readings is reported and stays as it is, whichever of them another language knows.
args fix app.sm
args fix label.sm
args fix lines.sm
args fix braces.sm
args fix numbers.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q @read_only
U8 mode @read_only
U8 mask @read_only
U8 count @read_only
U8 size @read_only @alias length
bool fault @read_only
bool valve
F64 n
[Run] @safe
.step
    n = count  // size
    n = count  // size and fault
    n = count  // length
    n = count  // -size
    n = G  // T
    n = count  // the size
    p > n % size: valve = true
    p > 5 && mode & mask: valve = true
    p > 5 & mode & mask: valve = true
    p > 5 | q > 5 && fault: valve = true
    p > 5 and q > 5 | fault: valve = true
    p > 5 & q > 5: valve = true
    |p - |q|| > 5: valve = true
    ||p| - q| > 5: valve = true
    not|p| > 5 || |q| > 5: valve = true
    n *= p + q
    n -= 2
    n /= max(p, q) # of both
    n = min(p, 0,5)
    n = clamp(p; 0,5)
    n = max(p, 1.5,2)
    n = 0·5
    n = (p = 9)
    if ((n = p) > 3): valve = true
    if max(p, b = 5) > 3: valve = true
    p = > 5: valve = true
    if (p = 7): valve = true
    (p = 8) and (q = 3): valve = true
-- label.sm --
[state_vector]
U64 G
U32 S
bool entry @read_only
bool lamp
[Run] @safe
.step
    entry:
        lamp = true
    entry
-- lines.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool fault @read_only
bool valve
bool pump
[Run] @safe
.step
    p > 5: -> Idle; pump = true
    fault: -> Abort; -> Idle
    if (p > 5) valve = true; pump = true;
    p > 6 then valve = true; pump = true
    if (p > 7) valve = true; else pump = true; valve = false
    if (p > 8) valve = true;
    -> Idle; pump = true
    if p > 9 then valve = true
        pump = true
    p > 10: valve = true; pump = true

        # and
        valve = false
    else pump = true
      valve = true
[Idle] @safe
[Abort] @safe
-- braces.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q @read_only
bool valve
[Run] @safe
.step
    if p > 5:
        q > 3: valve = true
      else: valve = false
    if p > 6:
        if q > 6:
            valve = true
          valve = false
    if p > 7:
        valve = true
	valve = false
    q > 7: p > 7:
        valve = true
    else: valve = false
    if p > 8:
        valve = (p +
    q) > 8
    if p > 9:
        if q > 9:
            valve = (p
      > 9)
        else: valve = false
-- numbers.sm --
[state_vector]
U64 G
U32 S
F64 a @range 0 – 5
F64 b @range –10 –5
F64 c @range -10 – 5
F64 d @range 0–5
F64 e
F64 f @range 0,5
F64 g @range 0,5; 1,5
F64 h @range 0,1,2
F64 i @range 0, 5 @read_only
[Run] @safe
.step
    e = a – b + c + d + f + g + h + i
-- stdout --
app.sm:20:
  -     n = count  // the size
  +     n = count  # the size
app.sm:22:
  -     p > 5 && mode & mask: valve = true
  +     p > 5 and mode & mask: valve = true
app.sm:24:
  -     p > 5 | q > 5 && fault: valve = true
  +     p > 5 | q > 5 and fault: valve = true
app.sm:26:
  -     p > 5 & q > 5: valve = true
  +     p > 5 and q > 5: valve = true
app.sm:29:
  -     not|p| > 5 || |q| > 5: valve = true
  +     not abs(p) > 5 or abs(q) > 5: valve = true
app.sm:41:
  -     if (p = 7): valve = true
  -     (p = 8) and (q = 3): valve = true
  +     if (p == 7): valve = true
  +     (p == 8) and (q == 3): valve = true
app.sm: 10 fixed
label.sm:8:
  -     entry:
  +     entry {
label.sm:10:
  +     }
label.sm: 1 fixed
lines.sm:12:
  -     if (p > 5) valve = true; pump = true;
  +     if (p > 5) valve = true; pump = true
lines.sm:14:
  -     if (p > 7) valve = true; else pump = true; valve = false
  -     if (p > 8) valve = true;
  +     if (p > 7) valve = true else pump = true; valve = false
  +     if (p > 8): valve = true
lines.sm: 4 fixed
braces.sm:25:
  -     if p > 9:
  +     if p > 9 {
braces.sm:30:
  +     }
braces.sm: 1 fixed
numbers.sm:5:
  - F64 b @range –10 –5
  + F64 b @range -10 –5
numbers.sm:12:
  - F64 i @range 0, 5 @read_only
  + F64 i @range 0 5 @read_only
numbers.sm:15:
  -     e = a – b + c + d + f + g + h + i
  +     e = a - b + c + d + f + g + h + i
numbers.sm: 3 fixed
-- stderr --
app.sm:15:16: error: a comment begins with '#', not with '//' [E0110]
   15 |     n = count  // size
      |                ^~ begin the comment with #; to divide and round down, write floor(a / b)
note: the same mistake is in lines 16, 17, 18, 19
app.sm:21:11: error: unknown operator '%' [E0108]
   21 |     p > n % size: valve = true
      |           ^ for a remainder, use x - n * floor(x / n); a comment begins with #
app.sm:22:20: error: '&' is written 'and' here [E0107]
   22 |     p > 5 and mode & mask: valve = true
      |                    ^ write and for conditions; there are no operators for the bits of a number
note: the same mistake is in line 23
app.sm:24:11: error: '|' is written 'or' here [E0107]
   24 |     p > 5 | q > 5 and fault: valve = true
      |           ^ write or for conditions; there are no operators for the bits of a number
note: the same mistake is in line 25
app.sm:27:5: error: unknown operator '|p - |q||' [E0108]
   27 |     |p - |q|| > 5: valve = true
      |     ^~~~~~~~~ write abs(x)
app.sm:28:5: error: unknown operator '||p| - q|' [E0108]
   28 |     ||p| - q| > 5: valve = true
      |     ^~~~~~~~~ write abs(x)
app.sm:29:5: warning: 'not' applies only to the next value [W0401 not-precedence]
   29 |     not abs(p) > 5 or abs(q) > 5: valve = true
      |     ^~~~~~~~~~
note: as written: (not abs(p)) > 5
note: perhaps meant: not (abs(p) > 5)
app.sm:30:7: error: unknown operator '*=' [E0326]
   30 |     n *= p + q
      |       ^~ write n = n * (...)
app.sm:31:7: error: unknown operator '-=' [E0326]
   31 |     n -= 2
      |       ^~ write n = n - ...
app.sm:32:7: error: unknown operator '/=' [E0326]
   32 |     n /= max(p, q) # of both
      |       ^~ write n = n / ...
app.sm:33:17: warning: this comma separates the numbers 0 and 5 [W0460 decimal-comma]
   33 |     n = min(p, 0,5)
      |                 ^ a decimal point is written 0.5; put a space after a comma that separates two values
app.sm:34:16: error: ';' is written ',' here [E0107]
   34 |     n = clamp(p; 0,5)
      |                ^ write ,
app.sm:36:10: error: the character '·' is allowed only in comments [E0102]
   36 |     n = 0·5
      |          ^ leave it out of the number; a decimal point is written .
app.sm:37:12: error: '=' assigns a value; use '==' to compare [E0324]
   37 |     n = (p = 9)
      |            ^ write ==
app.sm:38:12: error: '=' assigns a value; use '==' to compare [E0324]
   38 |     if ((n = p) > 3): valve = true
      |            ^ write ==
app.sm:39:17: error: '=' assigns a value; use '==' to compare [E0324]
   39 |     if max(p, b = 5) > 3: valve = true
      |                 ^ write ==
app.sm:40:9: error: expected a value after '=', found '>' [E0312]
   40 |     p = > 5: valve = true
      |         ^
15 errors, 2 warnings
label.sm:11:5: error: this value has no effect [E0327]
   11 |     entry
      |     ^~~~~ a statement is x = value, -> State, or condition: statement
1 error
lines.sm:10:19: error: a statement ends at the end of its line, without ';' [E0109]
   10 |     p > 5: -> Idle; pump = true
      |                   ^ put everything that depends on the condition in braces, each statement on a line of its own
note: the same mistake is in lines 11, 19
lines.sm:12:15: error: expected ':' or '{' after the condition, found 'valve' [E0315]
   12 |     if (p > 5) valve = true; pump = true
      |               ^ insert ':'
lines.sm:13:11: error: 'then' is not part of this language [E0329]
   13 |     p > 6 then valve = true; pump = true
      |           ^~~~ write ':' instead
lines.sm:14:15: error: expected ':' or '{' after the condition, found 'valve' [E0315]
   14 |     if (p > 7) valve = true else pump = true; valve = false
      |               ^ insert ':'
lines.sm:16:12: error: a statement ends at the end of its line, without ';' [E0109]
   16 |     -> Idle; pump = true
      |            ^ put each statement on a line of its own
lines.sm:17:14: error: 'then' is not part of this language [E0329]
   17 |     if p > 9 then valve = true
      |              ^~~~ write ':' instead
lines.sm:23:9: error: expected ':', '{' or 'if' after 'else', found 'pump' [E0319]
   23 |     else pump = true
      |         ^ insert ':'
7 errors
braces.sm:9:13: error: expected a statement after the condition, found the end of the line [E0316]
    9 |     if p > 5:
      |             ^ write '{' instead, and '}' after the statements that depend on the condition
note: statements on lines of their own need braces: p > 5 { ... }
note: the same mistake is in lines 12, 13, 16, 19, 22, 26
1 error
numbers.sm:4:16: error: the character '–' is allowed only in comments [E0102]
    4 | F64 a @range 0 – 5
      |                ^ separate two numbers by a space, and write a sign as -
numbers.sm:5:18: error: the character '–' is allowed only in comments [E0102]
    5 | F64 b @range -10 –5
      |                  ^ separate two numbers by a space, and write a sign as -
numbers.sm:6:18: error: the character '–' is allowed only in comments [E0102]
    6 | F64 c @range -10 – 5
      |                  ^ separate two numbers by a space, and write a sign as -
numbers.sm:7:15: error: the character '–' is allowed only in comments [E0102]
    7 | F64 d @range 0–5
      |               ^ separate two numbers by a space, and write a sign as -
numbers.sm:9:15: error: expected a number, the highest value of '@range', found ',' [E0377]
    9 | F64 f @range 0,5
      |               ^ write two numbers, as in @range 0 40
numbers.sm:10:15: error: expected a number, the highest value of '@range', found ',' [E0377]
   10 | F64 g @range 0,5; 1,5
      |               ^ write two numbers, as in @range 0 40
numbers.sm:11:15: error: expected a number, the highest value of '@range', found ',' [E0377]
   11 | F64 h @range 0,1,2
      |               ^ write two numbers, as in @range 0 40
7 errors
-- exit --
1 1 1 1 1
