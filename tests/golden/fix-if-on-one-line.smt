# IF ... THEN ...; END_IF; of IEC 61131 on one line is written as one condition with its statement.
args check a.sm
args fix a.sm
args check a.sm
args check b.sm

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y
[Run] @safe
.step
    IF x > 5 THEN y := 1; END_IF;
    IF x > 7 THEN y = 2; ENDIF      # later
    if x > 8 then y = max(x, 3); end if;
-- b.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y
[Run] @safe
.step
    if x > 5 THEN y = 1; y = 2; END_IF;
-- stdout --
a.sm:8:
  -     IF x > 5 THEN y := 1; END_IF;
  -     IF x > 7 THEN y = 2; ENDIF      # later
  -     if x > 8 then y = max(x, 3); end if;
  +     if x > 5: y = 1
  +     if x > 7: y = 2      # later
  +     if x > 8: y = max(x, 3)
a.sm: 6 fixed
-- stderr --
a.sm:8:5: error: 'IF' is not part of this language [E0329]
    8 |     IF x > 5 THEN y := 1; END_IF;
      |     ^~ write if
a.sm:9:5: error: 'IF' is not part of this language [E0329]
    9 |     IF x > 7 THEN y = 2; ENDIF      # later
      |     ^~ write if
a.sm:10:14: error: 'then' is not part of this language [E0329]
   10 |     if x > 8 then y = max(x, 3); end if;
      |              ^~~~ write ':' instead
3 errors
b.sm:8:14: error: 'THEN' is not part of this language [E0329]
    8 |     if x > 5 THEN y = 1; y = 2; END_IF;
      |              ^~~~ write ':' instead
1 error
-- exit --
1 0 0 1
